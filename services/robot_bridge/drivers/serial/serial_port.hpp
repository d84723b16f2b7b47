#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>

#include "services/robot_bridge/drivers/serial/serial_error.hpp"

namespace scarab::bridge::serial {

using Clock = std::chrono::steady_clock;
using Deadline = Clock::time_point;

/// An open serial port: raw bytes, 8N1, this process alone. Every call is bounded by its deadline;
/// every call but the destructor throws SerialError, whose fault() says why. Used by one thread.
class SerialPort {
 public:
  /// Opens `path` at `baud` (any rate: 57600, 1000000, 3000000 ...), asks for low latency and
  /// throws away what had already arrived.
  SerialPort(const std::string& path, unsigned baud);
  ~SerialPort();
  SerialPort(SerialPort&& other) noexcept;
  SerialPort& operator=(SerialPort&& other) noexcept;
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;

  /// All `size` bytes; they have left this process, not yet the wire, on return.
  void write(const std::uint8_t* data, std::size_t size, Deadline deadline);
  template <class Bytes>
  void write(const Bytes& bytes, Deadline deadline) {
    write(bytes.data(), bytes.size(), deadline);
  }

  /// Waits for bytes and takes what is there, at most `capacity`; 0: none came until the deadline
  /// (one in the past only looks).
  [[nodiscard]] std::size_t read_some(std::uint8_t* data, std::size_t capacity, Deadline deadline);
  template <class Buffer>
  [[nodiscard]] std::size_t read_some(Buffer& buffer, Deadline deadline) {
    return read_some(buffer.data(), buffer.size(), deadline);
  }

  /// Throws away what has arrived and was not read.
  void discard_input() noexcept;

  [[nodiscard]] int fd() const noexcept { return fd_; }
  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  /// What the port's hardware made of the rate it was asked for.
  [[nodiscard]] unsigned baud() const noexcept;

 private:
  /// False: the deadline came first. Throws if the port has gone and has no more to say.
  [[nodiscard]] bool wait_for(short events, Deadline deadline) const;

  std::string path_;
  int fd_ = -1;
};

}  // namespace scarab::bridge::serial
