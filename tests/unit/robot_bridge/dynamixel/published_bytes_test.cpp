// Frames as ROBOTIS prints them: e-Manual, "DYNAMIXEL Protocol 2.0"
// (https://emanual.robotis.com/docs/en/dxl/protocol2/), the examples of each instruction. Nothing
// here was made with our own encoder.

#include <gtest/gtest.h>

#include <string>

#include "services/robot_bridge/drivers/dynamixel/protocol/crc16.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/fast_status.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/instructions.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/packet.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/status.hpp"
#include "tests/unit/robot_bridge/dynamixel/frames.hpp"

namespace scarab::bridge::dynamixel {
namespace {

constexpr std::uint16_t kPresentPosition = 132;
constexpr std::uint16_t kGoalPosition = 116;

/// A packet and the frame it is on the wire, in both directions.
void expect_frame(const Packet& packet, const std::string& frame) {
  EXPECT_EQ(encode(packet), hex(frame)) << frame;
  EXPECT_EQ(parse_one(hex(frame)), packet) << frame;
}

Status answer(std::uint8_t id, Bytes data) { return {id, false, StatusError::kNone, data}; }

TEST(PublishedBytes, Ping) {
  expect_frame(ping(1), "FF FF FD 00 01 03 00 01 19 4E");
  expect_frame(ping(kBroadcastId), "FF FF FD 00 FE 03 00 01 31 42");
  // XM430-W210: model number 1030, firmware 38.
  expect_frame(to_packet(answer(1, to_data({1030, 38}))),
               "FF FF FD 00 01 07 00 55 00 06 04 26 65 5D");
  expect_frame(to_packet(answer(2, to_data({1030, 38}))),
               "FF FF FD 00 02 07 00 55 00 06 04 26 6F 6D");
}

TEST(PublishedBytes, APingIsAnsweredWithModelAndFirmware) {
  const auto status = as_status(parse_one(hex("FF FF FD 00 01 07 00 55 00 06 04 26 65 5D")));
  ASSERT_TRUE(status);
  EXPECT_EQ(status->id, 1);
  EXPECT_EQ(status->error, StatusError::kNone);
  EXPECT_FALSE(status->alert);
  const auto ping_answer = as_ping_answer(status->data);
  ASSERT_TRUE(ping_answer);
  EXPECT_EQ(ping_answer->model_number, 1030);
  EXPECT_EQ(ping_answer->firmware, 38);
}

TEST(PublishedBytes, Read) {
  expect_frame(read(1, {kPresentPosition, 4}), "FF FF FD 00 01 07 00 02 84 00 04 00 1D 15");
  expect_frame(to_packet(answer(1, {0xA6, 0, 0, 0})),
               "FF FF FD 00 01 08 00 55 00 A6 00 00 00 8C C0");
}

TEST(PublishedBytes, Write) {
  expect_frame(write(1, kGoalPosition, Bytes{0x00, 0x02, 0, 0}),
               "FF FF FD 00 01 09 00 03 74 00 00 02 00 00 CA 89");
  expect_frame(to_packet(answer(1, {})), "FF FF FD 00 01 04 00 55 00 A1 0C");
}

TEST(PublishedBytes, RegisteredWriteActionAndReboot) {
  expect_frame(reg_write(1, 104, Bytes{0xC8, 0, 0, 0}),
               "FF FF FD 00 01 09 00 04 68 00 C8 00 00 00 AE 8E");
  expect_frame(action(1), "FF FF FD 00 01 03 00 05 02 CE");
  expect_frame(reboot(1), "FF FF FD 00 01 03 00 08 2F 4E");
}

TEST(PublishedBytes, SyncRead) {
  expect_frame(sync_read({kPresentPosition, 4}, {1, 2}),
               "FF FF FD 00 FE 09 00 82 84 00 04 00 01 02 CE FA");
  expect_frame(to_packet(answer(1, {0xA6, 0, 0, 0})),
               "FF FF FD 00 01 08 00 55 00 A6 00 00 00 8C C0");
  expect_frame(to_packet(answer(2, {0x1F, 0x08, 0, 0})),
               "FF FF FD 00 02 08 00 55 00 1F 08 00 00 BA BE");
}

TEST(PublishedBytes, SyncWrite) {
  expect_frame(sync_write({{kGoalPosition, 4}, {{1, {0x96, 0, 0, 0}}, {2, {0xAA, 0, 0, 0}}}}),
               "FF FF FD 00 FE 11 00 83 74 00 04 00 01 96 00 00 00 02 AA 00 00 00 82 87");
}

const char* const kFastStatus3 = "FF FF FD 00 FE 19 00 55 00 03 A6 00 00 00 84 08";
const char* const kFastStatus7 = "00 07 1F 08 00 00 16 CA";
const char* const kFastStatus4 = "00 04 FF 03 00 00 D1 9E";

Bytes whole_fast_status() {
  return hex(std::string(kFastStatus3) + " " + kFastStatus7 + " " + kFastStatus4);
}

const std::vector<Status>& fast_answers() {
  static const std::vector<Status> answers = {
      answer(3, {0xA6, 0, 0, 0}), answer(7, {0x1F, 0x08, 0, 0}), answer(4, {0xFF, 0x03, 0, 0})};
  return answers;
}

TEST(PublishedBytes, FastSyncRead) {
  expect_frame(fast_sync_read({kPresentPosition, 4}, {3, 7, 4}),
               "FF FF FD 00 FE 0A 00 8A 84 00 04 00 03 07 04 20 F2");
  EXPECT_EQ(as_fast_status(parse_one(whole_fast_status()), 4), fast_answers());
  const std::vector<Bytes> expected = {hex(kFastStatus3), hex(kFastStatus7), hex(kFastStatus4)};
  EXPECT_EQ(encode_fast_status(fast_answers()), expected);
}

TEST(PublishedBytes, FastSyncReadOfOtherDevices) {  // the same in the manual of the JA40
  expect_frame(fast_sync_read({580, 4}, {1, 2}), "FF FF FD 00 FE 09 00 8A 44 02 04 00 01 02 72 F2");
  const std::vector<Status> answers = {answer(1, {0xD0, 0x07, 0, 0}), answer(2, {9, 0, 0, 0})};
  const std::vector<Bytes> expected = {hex("FF FF FD 00 FE 11 00 55 00 01 D0 07 00 00 0C 83"),
                                       hex("00 02 09 00 00 00 11 40")};
  EXPECT_EQ(encode_fast_status(answers), expected);
}

TEST(PublishedBytes, ABrokenFastStatusTellsWhoHasAnswered) {
  const Bytes whole = whole_fast_status();
  const std::size_t first = hex(kFastStatus3).size();
  const std::size_t second = first + hex(kFastStatus7).size();
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    const std::size_t answered = (size >= first) + (size >= second) + (size >= whole.size());
    const std::vector<Status> expected(fast_answers().begin(),
                                       fast_answers().begin() + static_cast<long>(answered));
    EXPECT_EQ(answered_so_far(ByteView(whole).slice(0, size), 4), expected) << size;
  }
}

TEST(PublishedBytes, Crc) {
  // The CRC of the read above; and the check value of CRC-16/BUYPASS ("A Painless Guide to CRC
  // Error Detection Algorithms" names the parameters, RevEng's catalogue the value).
  EXPECT_EQ(crc16(hex("FF FF FD 00 01 07 00 02 84 00 04 00")), 0x151D);
  const std::string digits = "123456789";
  EXPECT_EQ(crc16(Bytes(digits.begin(), digits.end())), 0xFEE8);
  const Bytes frame = hex("FF FF FD 00 01 07 00 02 84 00 04 00");
  EXPECT_EQ(crc16(ByteView(frame).from(5), crc16(ByteView(frame).slice(0, 5))), 0x151D);
}

}  // namespace
}  // namespace scarab::bridge::dynamixel
