#include "services/robot_bridge/drivers/dynamixel/protocol/parser.hpp"

#include <gtest/gtest.h>

#include "services/robot_bridge/drivers/dynamixel/protocol/crc16.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/fast_status.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/instructions.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/status.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/stuffing.hpp"
#include "tests/unit/robot_bridge/dynamixel/frames.hpp"

namespace scarab::bridge::dynamixel {
namespace {

const Packet kWanted = read(7, {132, 4});

/// Appends the right CRC to whatever stands there.
Bytes sealed(Bytes frame) {
  append_little(frame, crc16(frame), kCrcBytes);
  return frame;
}

Bytes joined(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(Parser, FindsPacketsHoweverTheyAreCut) {
  Bytes stream;
  for (const Packet& packet : {ping(1), ping(2), ping(3)}) stream = joined(stream, encode(packet));
  for (std::size_t piece = 1; piece <= stream.size(); ++piece) {
    Parser parser;
    std::vector<Packet> packets;
    for (std::size_t at = 0; at < stream.size(); at += piece) {
      parser.feed(ByteView(stream).slice(at, std::min(piece, stream.size() - at)), packets);
    }
    const std::vector<Packet> expected = {ping(1), ping(2), ping(3)};
    EXPECT_EQ(packets, expected) << "pieces of " << piece;
    EXPECT_EQ(parser.counters().bytes_dropped, 0U);
    EXPECT_TRUE(parser.pending().empty());
  }
}

TEST(Parser, StuffedBytesComeBackAsTheyWere) {
  const std::vector<Bytes> datas = {hex("FF FF FD"), hex("FF FF FD 00"), hex("FF FF FD FD"),
                                    hex("FF FF FF FD FF FF FD"), hex("00 FF FF FD FF FD FF FF")};
  for (const Bytes& data : datas) {
    const Packet packet = write(9, 0x1234, data);
    const Bytes frame = encode(packet);
    EXPECT_GT(frame.size(), kPrefixBytes + 1 + 2 + data.size() + kCrcBytes);  // something was added
    EXPECT_EQ(parse_one(frame), packet);
  }
}

TEST(Parser, AnAddressCanBePartOfAPattern) {  // address FFFF and data FD: stuffing spans both
  const Packet packet = write(9, 0xFFFF, hex("FD"));
  EXPECT_EQ(parse_one(encode(packet)), packet);
  EXPECT_EQ(stuff(hex("03 FF FF FD")), hex("03 FF FF FD FD"));
}

TEST(Parser, RefusesWhatIsNotStuffed) {
  Bytes inside{0xFF, 0xFF, 0xFD, 0x00, 9, 8, 0, 3, 0xFF, 0xFF, 0xFD, 0x07, 0x07};
  Bytes at_end{0xFF, 0xFF, 0xFD, 0x00, 9, 6, 0, 3, 0xFF, 0xFF, 0xFD};
  for (const Bytes& frame : {sealed(inside), sealed(at_end)}) {
    Parser parser;
    std::vector<Packet> packets;
    parser.feed(frame, packets);
    EXPECT_TRUE(packets.empty());
    EXPECT_EQ(parser.counters().stuffing_errors, 1U);
  }
}

TEST(Parser, RefusesImpossibleIdsAndLengths) {
  const std::vector<Bytes> frames = {hex("FF FF FD 00 FD 03 00 01"), hex("FF FF FD 00 FF 03 00 01"),
                                     hex("FF FF FD 00 01 02 00"), hex("FF FF FD 00 01 00 00"),
                                     hex("FF FF FD 00 01 01 04 01")};
  for (const Bytes& frame : frames) {
    Parser parser;
    std::vector<Packet> packets;
    parser.feed(sealed(frame), packets);
    EXPECT_TRUE(packets.empty());
    EXPECT_EQ(parser.counters().length_errors, 1U);
  }
}

TEST(Parser, RefusesEveryFlippedBit) {
  const Bytes frame = encode(write(5, 116, hex("12 34 56 78")));
  for (std::size_t bit = 0; bit < 8 * frame.size(); ++bit) {
    Bytes broken = frame;
    broken[bit / 8] = static_cast<std::uint8_t>(broken[bit / 8] ^ (1U << (bit % 8)));
    Parser parser;
    std::vector<Packet> packets;
    parser.feed(broken, packets);
    EXPECT_TRUE(packets.empty()) << "bit " << bit;
    parser.feed(encode(kWanted), packets);
    EXPECT_EQ(packets, std::vector<Packet>{kWanted}) << "bit " << bit;
  }
}

TEST(Parser, AnyHeadOfAPacketIsGivenUpForTheNextOne) {
  for (const Packet& cut : {write(5, 116, hex("FF FF FF FD 01 02 03 04")), read(5, {132, 10})}) {
    const Bytes frame = encode(cut);
    for (std::size_t size = 0; size < frame.size(); ++size) {
      Parser parser;
      std::vector<Packet> packets;
      parser.feed(
          joined(Bytes(frame.begin(), frame.begin() + static_cast<long>(size)), encode(kWanted)),
          packets);
      EXPECT_EQ(packets, std::vector<Packet>{kWanted}) << size << " bytes";
      EXPECT_EQ(parser.counters().bytes_dropped, size);
    }
  }
}

TEST(Parser, AFastStatusIsNotStuffedAndMayContainAHeader) {
  // A current of -1 count and a velocity of 253: FF FF FD 00.
  const std::vector<Status> statuses = {{1, false, StatusError::kNone, hex("FF FF FD 00 00 00")},
                                        {2, true, StatusError::kNone, hex("00 00 FF FF FD 00")}};
  Bytes frame;
  for (const Bytes& chunk : encode_fast_status(statuses)) frame = joined(frame, chunk);
  EXPECT_EQ(as_fast_status(parse_one(frame), 6), statuses);

  // Byte by byte, and the half of one before it.
  const Bytes half(frame.begin(), frame.begin() + static_cast<long>(frame.size() / 2));
  Parser parser;
  std::vector<Packet> packets;
  for (const std::uint8_t byte : joined(half, frame)) parser.feed({&byte, 1}, packets);
  ASSERT_EQ(packets.size(), 1U);
  EXPECT_EQ(as_fast_status(packets.front(), 6), statuses);
  EXPECT_EQ(parser.counters().bytes_dropped, half.size());
}

TEST(Parser, ABrokenFastStatusDoesNotHoldBackTheNextPacket) {
  const Bytes begun = hex("FF FF FD 00 FE FF 03 55 00 01");  // 1024 bytes, so it says
  Parser parser;
  std::vector<Packet> packets;
  parser.feed(joined(begun, encode(kWanted)), packets);
  EXPECT_EQ(packets, std::vector<Packet>{kWanted});
}

TEST(Parser, KeepsAtMostOneFrame) {
  Parser parser;
  std::vector<Packet> packets;
  const Bytes noise(100, 0xFF);
  const Bytes fast = hex("FF FF FD 00 FE 00 04 55");
  for (int round = 0; round < 1000; ++round) {
    parser.feed(round % 3 == 0 ? fast : noise, packets);
    EXPECT_LE(parser.pending().size(), kMaxFrameBytes);
  }
  EXPECT_TRUE(packets.empty());
  const std::uint64_t before = parser.counters().bytes_dropped;
  const std::size_t kept = parser.pending().size();
  parser.reset();
  EXPECT_EQ(parser.counters().bytes_dropped, before + kept);
  EXPECT_EQ(parser.counters().bytes_dropped, 334U * fast.size() + 666U * noise.size());
}

}  // namespace
}  // namespace scarab::bridge::dynamixel
