#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "services/robot_bridge/drivers/amosii/protocol/parsers.hpp"
#include "tests/unit/robot_bridge/serial/pseudo_terminal.hpp"

namespace scarab::bridge::amosii {

/// A board at the other end of a line, in a thread of its own.
class FakeBoard {
 public:
  /// What becomes of the bytes of one reply.
  using Mishap = std::function<test::Bytes(test::Bytes)>;

  FakeBoard() : thread_([this] { serve(); }) {}
  ~FakeBoard() {
    stop_ = true;
    thread_.join();
  }
  FakeBoard(const FakeBoard&) = delete;
  FakeBoard& operator=(const FakeBoard&) = delete;

  [[nodiscard]] const std::string& path() const { return line_.path(); }

  void sense(const Slots& sensors) {
    const std::lock_guard lock(mutex_);
    sensors_ = sensors;
  }
  /// The next replies go wrong, one after the other.
  void go_wrong(std::deque<Mishap> mishaps) {
    const std::lock_guard lock(mutex_);
    mishaps_ = std::move(mishaps);
  }
  /// The bytes that came since the last call, once there are `size` of them.
  test::Bytes take_received(std::size_t size) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(5);
    for (;;) {
      {
        const std::lock_guard lock(mutex_);
        if (received_.size() >= size || std::chrono::steady_clock::now() > deadline) {
          return std::exchange(received_, {});
        }
      }
      std::this_thread::yield();
    }
  }
  /// Ends the thread and the device with it.
  void unplug() {
    unplugged_ = true;
    while (!gone_) std::this_thread::yield();
  }

 private:
  void serve() {
    CommandParser parser;
    while (!stop_ && !unplugged_) {
      for (const std::uint8_t byte : line_.read(1, std::chrono::milliseconds(5))) {
        const auto command = parser.push(byte);
        const bool asked = command && std::holds_alternative<CommandParser::Get>(*command);
        if (const auto bytes = note(byte, asked)) line_.write(*bytes);
      }
    }
    line_.unplug();
    gone_ = true;
  }

  /// The bytes of the reply, if the byte completes a get.
  std::optional<test::Bytes> note(std::uint8_t byte, bool asked) {
    const std::lock_guard lock(mutex_);
    received_.push_back(byte);
    if (!asked) return std::nullopt;
    const ReplyFrame frame = encode_reply(sensors_);
    test::Bytes bytes(frame.begin(), frame.end());
    if (mishaps_.empty()) return bytes;
    const Mishap mishap = mishaps_.front();
    mishaps_.pop_front();
    return mishap(bytes);
  }

  test::PseudoTerminal line_;
  std::mutex mutex_;
  Slots sensors_ = all_slots(kMiddle);
  std::deque<Mishap> mishaps_;
  test::Bytes received_;
  std::atomic<bool> stop_{false};
  std::atomic<bool> unplugged_{false};
  std::atomic<bool> gone_{false};
  std::thread thread_;
};

}  // namespace scarab::bridge::amosii
