// What a cycle takes on the line, counted in the bytes of real frames; and whether the parser keeps
// up with the line.

#include <gtest/gtest.h>

#include <chrono>
#include <iostream>

#include "services/robot_bridge/drivers/dynamixel/protocol/fast_status.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/instructions.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/status.hpp"
#include "tests/unit/robot_bridge/dynamixel/frames.hpp"

namespace scarab::bridge::dynamixel {
namespace {

constexpr std::size_t kServos = 19;
constexpr std::size_t kFeedbackBytes = 10;  // current, velocity, position
constexpr std::size_t kImuBytes = 44;       // as in config/robot_bridge/beetle-dynamixel.yaml
constexpr double kFastestBaud = 4500000;    // of an XM430 (e-Manual, "Specifications")

std::vector<std::uint8_t> ids() {
  std::vector<std::uint8_t> all;
  for (std::size_t i = 1; i <= kServos; ++i) all.push_back(static_cast<std::uint8_t>(i));
  return all;
}

std::vector<Status> answers() {
  std::vector<Status> all;
  for (const std::uint8_t id : ids()) all.push_back({id, false, StatusError::kNone, Bytes(10)});
  return all;
}

std::size_t plain_read_bytes() {
  std::size_t bytes = encode(sync_read({126, kFeedbackBytes}, ids())).size();
  for (const Status& status : answers()) bytes += encode(to_packet(status)).size();
  return bytes;
}

std::size_t fast_read_bytes() {
  std::size_t bytes = encode(fast_sync_read({126, kFeedbackBytes}, ids())).size();
  for (const Bytes& chunk : encode_fast_status(answers())) bytes += chunk.size();
  return bytes;
}

/// Question and answer of a read of one device.
std::size_t read_bytes(std::size_t data_bytes) {
  return encode(read(1, {0, 1})).size() + status_bytes(data_bytes);
}

std::size_t write_bytes() {
  SyncWriteRequest request{{116, 4}, {}};
  for (const std::uint8_t id : ids()) request.items.push_back({id, Bytes(4)});
  return encode(sync_write(request)).size();
}

double milliseconds(std::size_t bytes, double baud) {
  return 1e3 * 10 * static_cast<double>(bytes) / baud;
}

TEST(BusTime, ACycleOfNineteenServosFitsIntoASensorPeriod) {
  const std::size_t others = read_bytes(1) + read_bytes(kImuBytes) + write_bytes();
  for (const double baud : {1e6, 4e6}) {
    const double plain_ms = milliseconds(plain_read_bytes() + others, baud);
    const double fast_ms = milliseconds(fast_read_bytes() + others, baud);
    std::cout << "a cycle at " << baud / 1e6 << " Mbaud: fast sync read " << fast_ms
              << " ms, plain " << plain_ms << " ms\n";
    EXPECT_LT(plain_ms, 20.0);
    EXPECT_LT(fast_ms, plain_ms);
  }
  std::cout << "bytes: fast sync read " << fast_read_bytes() << ", plain " << plain_read_bytes()
            << ", temperature " << read_bytes(1) << ", IMU " << read_bytes(kImuBytes) << ", goals "
            << write_bytes() << "\n";
}

TEST(BusTime, TheParserKeepsUpWithTheFastestLine) {
  using Clock = std::chrono::steady_clock;
  constexpr int kRounds = 20000;
  Bytes stream;
  for (const Bytes& chunk : encode_fast_status(answers())) {
    stream.insert(stream.end(), chunk.begin(), chunk.end());
  }
  const auto megabytes_per_s = [&](Clock::duration taken) {
    return 1e-6 * static_cast<double>(stream.size()) * kRounds /
           std::chrono::duration<double>(taken).count();
  };
  const Clock::time_point begun = Clock::now();
  std::size_t encoded = 0;
  for (int i = 0; i < kRounds; ++i) {
    for (const Bytes& chunk : encode_fast_status(answers())) encoded += chunk.size();
  }
  const Clock::time_point made = Clock::now();
  Parser parser;
  std::vector<Packet> packets;
  for (int i = 0; i < kRounds; ++i) parser.feed(stream, packets);
  const Clock::time_point parsed = Clock::now();

  EXPECT_EQ(encoded, stream.size() * kRounds);
  EXPECT_EQ(packets.size(), static_cast<std::size_t>(kRounds));
  std::cout << "encoded at " << megabytes_per_s(made - begun) << " MB/s, parsed at "
            << megabytes_per_s(parsed - made) << " MB/s; the line: " << kFastestBaud / 10 * 1e-6
            << " MB/s\n";
  EXPECT_GT(megabytes_per_s(parsed - made), kFastestBaud / 10 * 1e-6);
}

}  // namespace
}  // namespace scarab::bridge::dynamixel
