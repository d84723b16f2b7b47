#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <string>

#include "services/robot_bridge/drivers/dynamixel/protocol/parser.hpp"
#include "tests/unit/robot_bridge/dynamixel/random_stream.hpp"
#include "tests/unit/robot_bridge/dynamixel/stream_check.hpp"

namespace scarab::bridge::dynamixel {
namespace {

constexpr std::uint64_t kSeed = 20260106;
constexpr int kStreams = 100000;

Bytes operator+(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

void feed_in_pieces(Parser& parser, const Bytes& bytes, RandomStream& random,
                    std::vector<Packet>& packets) {
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t piece = std::min(1 + random.below(64), bytes.size() - at);
    parser.feed(ByteView(bytes).slice(at, piece), packets);
    ASSERT_LE(parser.pending().size(), kMaxFrameBytes);
    at += piece;
  }
}

/// Where the accepted packets stand in the stream, one behind the other; fewer if one of them does
/// not stand there.
std::vector<Found> placed(const std::vector<Packet>& accepted, const std::vector<Found>& there) {
  std::vector<Found> places;
  std::size_t from = 0;
  for (const Packet& packet : accepted) {
    const auto place = std::find_if(there.begin(), there.end(), [&](const Found& found) {
      return found.begin >= from && found.packet == packet;
    });
    if (place == there.end()) break;
    places.push_back(*place);
    from = place->end;
  }
  return places;
}

/// What the streams had in them, over all.
struct Sum {
  std::uint64_t bytes = 0;
  std::uint64_t accepted = 0;
  std::uint64_t hidden = 0;  ///< first packets in whose place a forged one was accepted
};

/// Garbage, then two packets. The first must be found as soon as it is whole, unless a packet that
/// fits every check reaches into it; the second always.
void try_stream(RandomStream& random, Sum& sum) {
  const Bytes garbage = random.garbage();
  const Packet first = random.packet();
  const Packet second = random.packet();
  const Bytes until_first = garbage + encode(first);
  const Bytes whole = until_first + encode(second);

  Parser parser;
  std::vector<Packet> accepted;
  feed_in_pieces(parser, until_first, random, accepted);
  const std::vector<Packet> early = accepted;
  feed_in_pieces(parser, encode(second), random, accepted);

  const std::vector<Found> there = packets_in(whole);
  const std::vector<Found> places = placed(accepted, there);
  ASSERT_EQ(places.size(), accepted.size()) << "a packet was accepted that is not there";
  ASSERT_FALSE(accepted.empty());
  EXPECT_EQ(accepted.back(), second);
  EXPECT_EQ(places.back().end, whole.size());
  if (early.empty() || !(early.back() == first)) {
    const bool hidden = std::any_of(places.begin(), places.end(), [&](const Found& found) {
      return found.begin < until_first.size() && found.end > garbage.size();
    });
    EXPECT_TRUE(hidden) << "the first packet after the garbage was lost";
    ++sum.hidden;
  }
  sum.bytes += whole.size();
  sum.accepted += accepted.size();
  EXPECT_EQ(parser.counters().packets, accepted.size());
}

TEST(ParserFuzz, RandomAndMutatedStreams) {
  std::cout << "seed " << kSeed << ", " << kStreams << " streams\n";
  Sum sum;
  for (int i = 0; i < kStreams && !HasFailure(); ++i) {
    RandomStream random(kSeed + static_cast<std::uint64_t>(i));
    SCOPED_TRACE("stream " + std::to_string(i));
    try_stream(random, sum);
  }
  std::cout << sum.bytes << " bytes, " << sum.accepted << " packets accepted, " << sum.hidden
            << " hidden by a forged one\n";
  EXPECT_GT(sum.accepted, 2U * kStreams);  // the garbage had whole packets in it, too
}

}  // namespace
}  // namespace scarab::bridge::dynamixel
