#pragma once

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <string>

#include "common/bus/clock.hpp"
#include "common/bus/sample_fields.hpp"
#include "tests/integration/plant/chain_ends.hpp"
#include "tests/support/files.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/status_watch.hpp"

namespace scarab::test {

/// A bridge process with the loopback driver between the test's own chain ends. Quick on its way
/// home, so that tests are.
class BridgeProcess : public testing::Test {
 protected:
  using Report = StatusWatch::Report;

  /// Configured as shipped, but for `changes` (YAML).
  void start_bridge(const std::string& changes, const Arguments& more = {}) {
    const std::string config = source_file("config").string();
    write_text(run_dir_ / "bridge.yaml",
               "extends: " + config + "/robot_bridge/beetle-loopback.yaml\ncalibration: " + config +
                   "/calibration/beetle-loopback.yaml\n" + "homing_velocity_rad_s: 3.0\n" +
                   changes);
    Arguments command = {program("scarab-robot-bridge"),
                         "--robot",
                         config + "/robot/beetle.yaml",
                         "--config",
                         run_dir_ / "bridge.yaml",
                         "--expect",
                         "robot_bridge=1,supervisor=1,premotor=1",
                         "--tag",
                         test_tag(),
                         "--run-dir",
                         run_dir_.path()};
    command.insert(command.end(), more.begin(), more.end());
    child_.emplace(command, run_dir_ / "robot_bridge-0");
  }

  /// Its first state of a trial, in which it is answered nothing yet.
  std::optional<scarab_RobotState> begin(std::uint32_t trial = 1, double time_limit_s = 1000) {
    EXPECT_TRUE(eventually([&] { return !sensors_.matched().empty(); })) << child_->err();
    ends_.tell_trial(trial, time_limit_s);
    auto state = ends_.states().await(trial, 0);
    EXPECT_TRUE(state) << child_->err();
    return state;
  }

  /// Answers every state with command_ until one fits; that one, or none in time. So no command
  /// ever goes stale meanwhile.
  std::optional<scarab_RobotState> answer_until(
      const std::function<bool(const scarab_RobotState&)>& fits) {
    std::optional<scarab_RobotState> found;
    eventually([&] {
      const auto& states = ends_.states().all();
      for (; answered_ < states.size() && !found; ++answered_) {
        if (fits(states[answered_])) found = states[answered_];
        ends_.behave(states[answered_]);
        ends_.command(command_(states[answered_]));
      }
      return found.has_value();
    });
    return found;
  }
  std::optional<scarab_RobotState> answer_until(scarab_TrialPhase phase) {
    return answer_until([phase](const auto& state) { return state.phase == phase; });
  }
  void answer_ticks(std::uint32_t count) {
    std::uint32_t seen = 0;
    ASSERT_TRUE(answer_until([&](const auto&) { return ++seen == count; })) << child_->err();
  }

  void tell(scarab_OperatorCommand command, const std::string& reason = "") {
    scarab_Operator order{};
    order.command = command;
    order.header.stamp_ns = bus::now_ns();
    bus::assign(order.reason, reason);
    ASSERT_TRUE(eventually([&] { return !operator_.matched().empty(); }));
    operator_.write(order);
  }

  std::optional<Report> await(const std::function<bool(const Report&)>& fits) {
    return status_.await(self_, fits);
  }
  bool says(const std::string& part) { return status_.await_message(self_, part).has_value(); }
  /// Of a report that is not older than this tick.
  std::uint64_t counter(const std::string& name, std::uint32_t tick = 0) {
    const auto report = await([&](const Report& r) {
      return r.header.tick >= tick && r.counters.find(name) != r.counters.end();
    });
    return report ? report->counters.at(name) : 0;
  }

  static bool all_measured(const scarab_RobotState& state) {
    return std::all_of(std::begin(state.position_source), std::end(state.position_source),
                       [](auto source) { return source == scarab_SOURCE_MEASURED; });
  }

  const bus::Peer self_{"robot_bridge", 0};
  TemporaryDirectory run_dir_;
  StatusWatch status_;
  ChainEnds ends_;
  bus::Participant view_{test_options("view")};
  Inbox<scarab_RobotState> sensors_{view_, bus::kRobotSensors};
  bus::Writer<scarab_Operator> operator_{view_, bus::kOperator};
  std::optional<ChildProcess> child_;
  std::size_t answered_ = 0;  // of ends_.states()
  std::function<scarab_JointCommand(const scarab_RobotState&)> command_ = ChainEnds::command_for;
};

/// The pose that the shipped file says, by joint slot.
inline double start_pose_rad(std::size_t slot) {
  constexpr double kRows[3][3] = {// T, C, F of front, middle, hind
                                  {0.1523, -0.204, 1.0719},
                                  {0.3293, -0.271, 0.5294},
                                  {0.6081, -0.2613, 1.2304}};
  return slot == 18 ? 0.07788 : kRows[slot % 3][slot / 6];
}

}  // namespace scarab::test
