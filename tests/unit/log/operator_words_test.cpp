/// From which tick on a person's words counted.
#include "tools/log/replay/operator_words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/runtime/status_publisher.hpp"
#include "tests/unit/log/behaviour_log.hpp"
#include "tests/unit/mcap/temporary_folder.hpp"

namespace scarab::log::test {
namespace {

class Words : public testing::Test {
 protected:
  void say(std::int64_t stamp_ns, scarab_OperatorCommand command) {
    scarab_Operator word{};
    word.header.stamp_ns = stamp_ns;
    word.command = command;
    log_.write(bus::kOperator, word, 0);
  }
  void acknowledge(const std::string& service, std::int64_t stamp_ns, std::uint32_t tick) {
    std::string name = service;
    scarab_ServiceStatus status{};
    status.header = {1, tick, 0, 0};
    bus::borrow(status.service, name);
    std::vector<scarab_Counter> counters(1);
    bus::assign(counters[0].name, runtime::kOperatorStamp);
    counters[0].value = static_cast<std::uint64_t>(stamp_ns);
    bus::borrow(status.counters, counters);
    log_.write(bus::kServiceStatus, status, 0);
  }
  mcap::test::TemporaryFolder folder_;
  LogWriter log_{folder_ / "x.mcap"};
};

TEST_F(Words, CountFromTheTickThatTheSupervisorAcknowledgedThemIn) {
  say(40, scarab_OPERATOR_AUTOMATIC);  // heard in the same tick as the next: one acknowledgement
  say(50, scarab_OPERATOR_MODE);
  say(55, scarab_OPERATOR_EMERGENCY_STOP);  // not for the supervisor
  acknowledge("plant", 55, 2);
  acknowledge("supervisor", 50, 3);
  acknowledge("supervisor", 50, 9);  // said again with every later report
  say(60, scarab_OPERATOR_INPUTS);   // the recording ended before it was heard
  log_.close();
  const Log log(folder_ / "x.mcap");
  const OperatorWords words(log, {"supervisor", 0});
  EXPECT_TRUE(words.counting_from(1, 2).empty());
  const auto& heard = words.counting_from(1, 3);
  ASSERT_EQ(heard.size(), 2U);
  const auto second = bus::decode<scarab_Operator>(
      {reinterpret_cast<const std::byte*>(heard[1].cdr.data()), heard[1].cdr.size()});
  EXPECT_EQ(second->command, scarab_OPERATOR_MODE);
  EXPECT_TRUE(words.counting_from(1, 9).empty());
  EXPECT_TRUE(words.knows(40));
  EXPECT_FALSE(words.knows(55));
  EXPECT_FALSE(words.knows(60));
}

TEST_F(Words, AreNotForThePremotorController) {
  say(50, scarab_OPERATOR_MODE);
  acknowledge("supervisor", 50, 3);
  log_.close();
  const Log log(folder_ / "x.mcap");
  EXPECT_FALSE(OperatorWords(log, {"premotor", 0}).knows(50));
}

}  // namespace
}  // namespace scarab::log::test
