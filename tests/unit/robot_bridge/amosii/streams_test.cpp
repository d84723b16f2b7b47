#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <random>
#include <vector>

#include "services/robot_bridge/drivers/amosii/protocol/parsers.hpp"

/// 100,000 random and mutated streams into each parser: what it accepts must pass checks written
/// down a second time here, and every frame that arrives whole must be accepted with its last byte.
namespace scarab::bridge::amosii {
namespace {

constexpr int kStreams = 100'000;
constexpr std::uint64_t kSeed = 20261122;

using Bytes = std::vector<std::uint8_t>;

class Noise {
 public:
  explicit Noise(std::uint64_t seed) : generator_(seed) {}
  std::size_t below(std::size_t end) { return generator_() % end; }
  std::uint8_t byte() { return static_cast<std::uint8_t>(below(256)); }
  std::uint8_t non_zero() { return static_cast<std::uint8_t>(1 + below(255)); }

 private:
  std::mt19937_64 generator_;
};

bool has_no_servo(std::size_t slot) {
  return (2 <= slot && slot <= 8) || (15 <= slot && slot <= 18) || slot > 30;
}

Bytes set_frame(Noise& noise) {
  Bytes frame = {1};
  for (std::size_t slot = 1; slot <= 32; ++slot) {
    frame.push_back(has_no_servo(slot) ? 128 : noise.non_zero());
  }
  frame.push_back(0);
  return frame;
}

Bytes reply_frame(Noise& noise) {
  Bytes frame;
  for (std::size_t slot = 1; slot <= 32; ++slot) frame.push_back(noise.non_zero());
  frame.push_back(0);
  return frame;
}

/// A few bytes flipped, lost, added or said twice; cut off; or noise in its place. Bytes that steer
/// the protocol are drawn often.
Bytes damaged(Bytes frame, Noise& noise) {
  for (std::size_t wounds = 1 + noise.below(3); wounds > 0 && !frame.empty(); --wounds) {
    const auto at = frame.begin() + static_cast<std::ptrdiff_t>(noise.below(frame.size()));
    const std::uint8_t byte =
        noise.below(2) == 0 ? noise.byte() : static_cast<std::uint8_t>(noise.below(3));
    switch (noise.below(5)) {
      case 0:
        *at = byte;
        break;
      case 1:
        frame.erase(at);
        break;
      case 2:
        frame.insert(at, byte);
        break;
      case 3:
        frame.erase(at, frame.end());
        break;
      default:
        for (std::uint8_t& each : frame) each = noise.byte();
    }
  }
  return frame;
}

struct Stream {
  Bytes bytes;
  std::vector<std::size_t> ends;  ///< of frames that were not touched: index of the last byte
};

template <class MakeFrame>
Stream make_stream(Noise& noise, MakeFrame make_frame) {
  Stream stream;
  for (std::size_t frames = 1 + noise.below(6); frames > 0; --frames) {
    const bool whole = noise.below(2) == 0;
    const Bytes frame = whole ? make_frame(noise) : damaged(make_frame(noise), noise);
    stream.bytes.insert(stream.bytes.end(), frame.begin(), frame.end());
    if (whole) stream.ends.push_back(stream.bytes.size() - 1);
  }
  return stream;
}

/// The bytes up to `end` are a frame with these slots.
bool ends_frame_with(const Bytes& stream, std::size_t end, const Slots& slots) {
  if (end < 32 || stream[end] != 0) return false;
  return std::equal(slots.bytes.begin(), slots.bytes.end(),
                    stream.begin() + static_cast<std::ptrdiff_t>(end) - 32);
}

void check_set(const Bytes& stream, std::size_t end, const Slots& motors) {
  ASSERT_TRUE(ends_frame_with(stream, end, motors));
  ASSERT_GE(end, 33U);
  ASSERT_EQ(stream[end - 33], 1);
  for (std::size_t slot = 1; slot <= 32; ++slot) {
    const int byte = stream[end - 33 + slot];
    ASSERT_NE(byte, 0);
    ASSERT_TRUE(byte == 128 || !has_no_servo(slot));
  }
}

void check_reply(const Bytes& stream, std::size_t end, const Slots& sensors) {
  ASSERT_TRUE(ends_frame_with(stream, end, sensors));
  for (const std::size_t slot : {1, 2, 9, 10, 11, 12, 13, 14, 15, 18, 23, 25, 26, 27, 28, 30, 32}) {
    ASSERT_NE(stream[end - 33 + slot], 0);
  }
}

bool is_end(const Stream& stream, std::size_t at) {
  return std::find(stream.ends.begin(), stream.ends.end(), at) != stream.ends.end();
}

TEST(AmosiiStreams, CommandsAreFoundAndNothingElse) {
  std::cout << "seed " << kSeed << "\n";
  Noise noise(kSeed);
  std::size_t found = 0;
  for (int n = 0; n < kStreams && !HasFatalFailure(); ++n) {
    const Stream stream = make_stream(noise, [](Noise& source) {
      return source.below(3) == 0 ? Bytes{2, 0} : set_frame(source);
    });
    CommandParser parser;
    for (std::size_t i = 0; i < stream.bytes.size(); ++i) {
      const auto command = parser.push(stream.bytes[i]);
      ASSERT_TRUE(command.has_value() || !is_end(stream, i)) << "stream " << n << ", byte " << i;
      if (!command) continue;
      ++found;
      if (const auto* motors = std::get_if<Slots>(&*command)) {
        ASSERT_NO_FATAL_FAILURE(check_set(stream.bytes, i, *motors)) << "stream " << n;
      } else {
        ASSERT_TRUE(i >= 1 && stream.bytes[i - 1] == 2 && stream.bytes[i] == 0) << "stream " << n;
      }
    }
  }
  std::cout << found << " commands\n";
  EXPECT_GT(found, std::size_t{kStreams});
}

TEST(AmosiiStreams, RepliesAreFoundAndNothingElse) {
  std::cout << "seed " << kSeed << "\n";
  Noise noise(kSeed);
  std::size_t found = 0;
  for (int n = 0; n < kStreams && !HasFatalFailure(); ++n) {
    const Stream stream = make_stream(noise, reply_frame);
    ReplyParser parser;
    for (std::size_t i = 0; i < stream.bytes.size(); ++i) {
      const auto reply = parser.push(stream.bytes[i]);
      ASSERT_TRUE(reply.has_value() || !is_end(stream, i)) << "stream " << n << ", byte " << i;
      if (!reply) continue;
      ++found;
      ASSERT_NO_FATAL_FAILURE(check_reply(stream.bytes, i, *reply)) << "stream " << n;
    }
  }
  std::cout << found << " replies\n";
  EXPECT_GT(found, std::size_t{kStreams});
}

}  // namespace
}  // namespace scarab::bridge::amosii
