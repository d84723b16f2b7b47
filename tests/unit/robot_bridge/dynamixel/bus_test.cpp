// The bus against bytes as ROBOTIS prints them (e-Manual, "DYNAMIXEL Protocol 2.0").

#include "services/robot_bridge/drivers/dynamixel/bus.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <thread>

#include "tests/unit/robot_bridge/dynamixel/frames.hpp"
#include "tests/unit/robot_bridge/serial/pseudo_terminal.hpp"

namespace scarab::bridge::dynamixel {
namespace {

using test::PseudoTerminal;

constexpr Region kPresentPosition{132, 4};

BusOptions options_for(const PseudoTerminal& line) {
  return {line.path(), 1000000, 0.1, 2, {{7, "joint CR1"}}};
}

/// The other end says `answers`, one after each instruction of `size` bytes that it hears.
std::thread device(PseudoTerminal& line, std::size_t size, std::vector<Bytes> answers) {
  return std::thread([&line, size, answers = std::move(answers)] {
    for (const Bytes& answer : answers) {
      if (line.read(size).size() == size) line.write(answer);
    }
  });
}

TEST(Bus, AsksOneDevice) {
  PseudoTerminal line;
  Bus bus(options_for(line));
  bus.open();
  std::thread servo = device(line, 10, {hex("FF FF FD 00 01 07 00 55 00 06 04 26 65 5D")});
  const Status status = bus.ask(ping(1), 3);
  servo.join();
  EXPECT_EQ(status.data, hex("06 04 26"));
  EXPECT_EQ(bus.counters().exchanges, 1U);
  EXPECT_EQ(bus.counters().retries, 0U);
}

TEST(Bus, ReadsAllOneByOne) {
  PseudoTerminal line;
  Bus bus(options_for(line));
  bus.open();
  std::thread servos = device(line, 16,
                              {hex("FF FF FD 00 01 08 00 55 00 A6 00 00 00 8C C0 "
                                   "FF FF FD 00 02 08 00 55 00 1F 08 00 00 BA BE")});
  const std::vector<Status> answers = bus.read_all(kPresentPosition, {1, 2}, SyncReadKind::kPlain);
  servos.join();
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(read_little(answers[0].data), 166U);
  EXPECT_EQ(read_little(answers[1].data), 2079U);
}

const char* const kFastAnswer =
    "FF FF FD 00 FE 19 00 55 00 03 A6 00 00 00 84 08 00 07 1F 08 00 00 16 CA "
    "00 04 FF 03 00 00 D1 9E";

TEST(Bus, ReadsAllTogether) {
  PseudoTerminal line;
  Bus bus(options_for(line));
  bus.open();
  std::thread servos = device(line, 17, {hex(kFastAnswer)});
  const auto answers = bus.read_all(kPresentPosition, {3, 7, 4}, SyncReadKind::kFast);
  servos.join();
  ASSERT_EQ(answers.size(), 3U);
  EXPECT_EQ(answers[1].id, 7);
  EXPECT_EQ(read_little(answers[1].data), 2079U);
  EXPECT_EQ(read_little(answers[2].data), 1023U);
}

TEST(Bus, AsksAgainAfterABrokenAnswer) {
  PseudoTerminal line;
  Bus bus(options_for(line));
  bus.open();
  Bytes broken = hex(kFastAnswer);
  broken[20] ^= 0x10;
  std::thread servos = device(line, 17, {broken, hex(kFastAnswer)});
  const serial::Deadline begun = serial::Clock::now();
  const auto answers = bus.read_all(kPresentPosition, {3, 7, 4}, SyncReadKind::kFast);
  const auto taken = serial::Clock::now() - begun;
  servos.join();
  EXPECT_EQ(answers.size(), 3U);
  EXPECT_EQ(bus.counters().retries, 1U);
  EXPECT_EQ(bus.parser_counters().crc_errors, 1U);
  EXPECT_EQ(bus.counters().timeouts, 0U);  // what came in full is not waited for
  EXPECT_LT(taken, std::chrono::milliseconds(100));
}

TEST(Bus, OnlyThoseWhoseAnswersAreMissingAreAskedAgain) {
  PseudoTerminal line;
  Bus bus(options_for(line));
  bus.open();
  Bytes first_broken = hex(
      "FF FF FD 00 01 08 00 55 00 A6 00 00 00 8C C0 FF FF FD 00 02 08 00 55 00 1F 08 00 00 BA BE");
  first_broken[9] ^= 0xFF;
  Bytes second;
  std::thread servos([&] {
    line.read(16);
    line.write(first_broken);
    second = line.read(15);
    line.write(hex("FF FF FD 00 01 08 00 55 00 A6 00 00 00 8C C0"));
  });
  const std::vector<Status> answers = bus.read_all(kPresentPosition, {1, 2}, SyncReadKind::kPlain);
  servos.join();
  EXPECT_EQ(parse_one(second), sync_read(kPresentPosition, {1}));
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(read_little(answers[0].data), 166U);
  EXPECT_EQ(read_little(answers[1].data), 2079U);
}

TEST(Bus, NamesTheFirstThatIsSilentInAJointAnswer) {
  PseudoTerminal line;
  BusOptions options = options_for(line);
  options.retries = 0;
  options.reply_timeout_s = 0.02;
  Bus bus(options);
  bus.open();
  std::thread servos = device(line, 17, {hex("FF FF FD 00 FE 19 00 55 00 03 A6 00 00 00 84 08")});
  std::string error;
  try {
    bus.read_all(kPresentPosition, {3, 7, 4}, SyncReadKind::kFast);
  } catch (const DeviceError& e) {
    error = e.what();
  }
  servos.join();
  EXPECT_EQ(error, line.path() + ": joint CR1 (ID 7) does not answer (attempts: 1)");
}

TEST(Bus, AnAdapterMayEchoWhatIsSent) {
  PseudoTerminal line;
  Bus bus(options_for(line));
  bus.open();
  std::thread servo = device(line, 10,
                             {hex("FF FF FD 00 01 03 00 01 19 4E "
                                  "FF FF FD 00 01 07 00 55 00 06 04 26 65 5D")});
  EXPECT_EQ(bus.ask(ping(1), 3).data, hex("06 04 26"));
  servo.join();
  EXPECT_EQ(bus.counters().echoes, 1U);
}

TEST(Bus, AnswersOfOthersAreNotTaken) {
  PseudoTerminal line;
  Bus bus(options_for(line));
  bus.open();
  std::thread servo([&line] {
    line.read(10);
    line.write(hex("FF FF FD 00 02 07 00 55 00 06 04 26 6F 6D"));  // ID 2's
    line.write(hex("FF FF FD 00 01 04 00 55 00 A1 0C"));           // too short
    std::this_thread::sleep_for(std::chrono::milliseconds(5));     // let them be read first
    line.write(hex("FF FF FD 00 01 07 00 55 00 06 04 26 65 5D"));
  });
  EXPECT_EQ(bus.ask(ping(1), 3).data, hex("06 04 26"));
  servo.join();
  EXPECT_EQ(bus.counters().wrong_answers, 2U);
  EXPECT_EQ(bus.counters().retries, 0U);
}

TEST(Bus, ARefusalIsNamed) {
  PseudoTerminal line;
  Bus bus(options_for(line));
  bus.open();
  const Bytes refusal = encode(to_packet({7, false, StatusError::kDataRange, {}}));
  std::thread servo = device(line, 16, {refusal, refusal, refusal});
  std::string error;
  try {
    bus.ask(write(7, 116, hex("00 00 00 00")), 0);
  } catch (const DeviceError& e) {
    error = e.what();
  }
  servo.join();
  EXPECT_EQ(error, line.path() + ": joint CR1 (ID 7) refuses instruction 3: data range error");
  EXPECT_EQ(bus.counters().refusals, 3U);
}

TEST(Bus, ALateAnswerIsNotTakenForTheNext) {
  PseudoTerminal line;
  BusOptions options = options_for(line);
  options.reply_timeout_s = 0.03;
  Bus bus(options);
  bus.open();
  EXPECT_FALSE(bus.ask_once(read(1, kPresentPosition), 4));
  line.read(14);
  line.write(hex("FF FF FD 00 01 08 00 55 00 A6 00 00 00 8C C0"));  // 166, too late
  std::thread servo = device(line, 14, {hex("FF FF FD 00 02 08 00 55 00 1F 08 00 00 BA BE")});
  EXPECT_EQ(read_little(bus.ask(read(2, kPresentPosition), 4).data), 2079U);
  servo.join();
  EXPECT_EQ(bus.counters().bytes_late, 15U);
  EXPECT_EQ(bus.counters().wrong_answers, 0U);
}

TEST(Bus, ClosedOneSaysSo) {
  Bus bus({"/dev/none", 57600, 0.01, 0, {}});
  EXPECT_THROW(bus.open(), serial::SerialError);
  EXPECT_THROW(bus.tell(ping(1)), DeviceError);
}

}  // namespace
}  // namespace scarab::bridge::dynamixel
