#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "services/robot_bridge/drivers/dynamixel/protocol/control_table.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/instructions.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/parser.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/status.hpp"
#include "services/robot_bridge/drivers/serial/serial_port.hpp"
#include "tests/support/eventually.hpp"

namespace scarab::test {

namespace dxl = bridge::dynamixel;
using Bytes = std::vector<std::uint8_t>;

/// The host's end of the line: raw bytes out, raw bytes in, and how long they took.
class Line {
 public:
  using Clock = std::chrono::steady_clock;

  Line(const std::filesystem::path& device, unsigned baud) : port_(device.string(), baud) {}

  void send(const Bytes& bytes) { port_.write(bytes, Clock::now() + kPatience); }
  /// The next `size` bytes; fewer once `limit` has passed without them.
  Bytes receive(std::size_t size, std::chrono::milliseconds limit = kPatience) {
    const auto deadline = Clock::now() + limit;
    Bytes all;
    while (all.size() < size) {
      Bytes some(size - all.size());
      const std::size_t count = port_.read_some(some, deadline);
      if (count == 0) break;
      all.insert(all.end(), some.begin(), some.begin() + static_cast<long>(count));
    }
    return all;
  }

  struct Timed {
    Bytes bytes;
    std::chrono::nanoseconds took{};
  };
  /// Sends, and measures until the last of `size` bytes is there.
  Timed exchange(const Bytes& bytes, std::size_t size,
                 std::chrono::milliseconds limit = kPatience) {
    const auto start = Clock::now();
    send(bytes);
    Timed timed{receive(size, limit), {}};
    timed.took = Clock::now() - start;
    return timed;
  }

 private:
  bridge::serial::SerialPort port_;
};

/// The same in DYNAMIXEL's words, one status an answer.
class DynamixelLine : public Line {
 public:
  explicit DynamixelLine(const std::filesystem::path& device) : Line(device, 1'000'000) {}

  /// None: no whole status within `limit`.
  std::optional<dxl::Status> ask(const dxl::Packet& packet,
                                 std::chrono::milliseconds limit = kPatience) {
    send(dxl::encode(packet));
    const auto deadline = Clock::now() + limit;
    dxl::Parser parser;
    std::vector<dxl::Packet> packets;
    while (packets.empty() && Clock::now() < deadline) {
      parser.feed(receive(1, std::chrono::duration_cast<std::chrono::milliseconds>(deadline -
                                                                                   Clock::now())),
                  packets);
    }
    return packets.empty() ? std::nullopt : dxl::as_status(packets.front());
  }
  /// A status without error.
  bool write(std::uint8_t id, const dxl::Item& item, std::int64_t count) {
    const auto status = ask(dxl::write(id, item.address, dxl::bytes_of(item, count)));
    return status && status->error == dxl::StatusError::kNone;
  }
  std::optional<std::int64_t> read(std::uint8_t id, const dxl::Item& item) {
    const auto status = ask(dxl::read(id, item.region()));
    if (!status || status->data.size() != item.size()) return std::nullopt;
    return dxl::count_in(item, status->data);
  }
  /// All servos hold where they are.
  bool power_all() {
    for (std::uint8_t id = 1; id <= kServos; ++id) {
      const auto ticks = read(id, kModel.present_position);
      if (!ticks || !write(id, kModel.goal_position, *ticks)) return false;
    }
    for (std::uint8_t id = 1; id <= kServos; ++id) {
      if (!write(id, kModel.torque_enable, 1)) return false;
    }
    return true;
  }

  static constexpr std::uint8_t kServos = 19;  // IDs 1 to 19: joint slot + 1
  static constexpr dxl::ServoModel kModel{};
};

}  // namespace scarab::test
