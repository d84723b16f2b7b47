#include <gmock/gmock.h>

#include <csignal>
#include <iostream>

#include "common/bus/clock.hpp"
#include "common/bus/sample_fields.hpp"
#include "common/bus/writer.hpp"
#include "tests/support/files.hpp"
#include "tests/support/status_watch.hpp"
#include "tests/system/robot_bridge/robot_stack.hpp"
#include "tests/system/view.hpp"

namespace scarab::test {
namespace {

using testing::HasSubstr;

constexpr std::int64_t kMs = 1'000'000;  // ns
/// A process that is asked to do something on a loaded machine.
constexpr std::int64_t kSchedulingNs = 100 * kMs;
constexpr std::int64_t kTickNs = 100 * kMs;
constexpr std::int64_t kSensorPeriodNs = 20 * kMs;  // config/robot_bridge/beetle-dynamixel.yaml
constexpr std::int64_t kConfirmations = 3;          // of a reading beyond a limit; there

/// A robot that walks; then something happens that must stop it. What counts is the emulator's end
/// of the wire: when the last goal came that was another than the one before.
class SafeStop : public testing::Test {
 protected:
  using Report = StatusWatch::Report;

  void walk(const RobotStack::Options& options = {}) {
    stack_.emplace(directory_ / "stack", options);
    experiment_.emplace(
        stack_->conduct({"--strategy", "walk-backward", "--goal", "none", "--no-perturbation"}));
    ASSERT_TRUE(view_.await_tick(15)) << stack_->errors();
    const std::int64_t now_ns = bus::now_ns();
    ASSERT_TRUE(eventually([&] { return stack_->journal().first_after("goal", now_ns); }))
        << "it does not walk" << stack_->errors();
  }

  /// Has the emulator do something to the robot; when it did.
  std::int64_t misbehave(const Arguments& words) {
    const std::int64_t now_ns = bus::now_ns();
    EXPECT_TRUE(stack_->tell(words));
    std::optional<WireJournal::Event> began;
    EXPECT_TRUE(eventually([&] {
      began = stack_->journal().first_after("fault_on", now_ns);
      return began.has_value();
    }));
    return began ? began->stamp_ns : now_ns;
  }

  std::int64_t say(scarab_OperatorCommand command, const std::string& reason) {
    EXPECT_TRUE(eventually([&] {
      for (const auto& peer : operator_.matched()) {
        if (peer.service == "robot_bridge") return true;
      }
      return false;
    }));
    scarab_Operator said{};
    said.command = command;
    bus::assign(said.reason, reason);
    said.header.stamp_ns = bus::now_ns();
    operator_.write(said);
    return said.header.stamp_ns;
  }

  /// The bridge's word for why the robot stands still.
  void expect_reason(const std::string& part) {
    const auto report = status_.await_message({"robot_bridge", 0}, part);
    EXPECT_TRUE(report) << part << "\n" << stack_->errors();
    if (report) std::cout << "  it says: " << report->message << "\n";
  }

  /// Until no new goal has come for longer than any tick; how long after its cause the last came.
  std::int64_t await_stillness(const std::string& cause, std::int64_t cause_ns,
                               std::int64_t most_ns) {
    const auto last_goal_ns = [&] { return stack_->journal().last("goal")->stamp_ns; };
    EXPECT_TRUE(eventually([&] { return bus::now_ns() - last_goal_ns() > 5 * kTickNs; }))
        << "it still moves";
    const std::int64_t after_ns = last_goal_ns() - cause_ns;
    std::cout << cause << ": last goal written " << static_cast<double>(after_ns) / kMs
              << " ms after it\n";
    EXPECT_LE(after_ns, most_ns);
    return after_ns;
  }

  /// Nothing moves the robot any more but a reset, which brings it home, and on.
  void expect_reset_works() {
    const std::int64_t reset_ns = say(scarab_OPERATOR_RESET, "looked after");
    EXPECT_TRUE(eventually([&] { return stack_->journal().first_after("goal", reset_ns); }))
        << stack_->errors();
    EXPECT_TRUE(status_.await({"robot_bridge", 0}, [](const Report& report) {
      return report.health == scarab_HEALTH_OK && report.lifecycle == scarab_LIFECYCLE_ACTIVE;
    })) << stack_->errors();
  }

  TemporaryDirectory directory_;
  View view_;
  StatusWatch status_;
  bus::Participant participant_{test_options("operator")};
  bus::Writer<scarab_Operator> operator_{participant_, bus::kOperator};
  std::optional<RobotStack> stack_;
  std::optional<ChildProcess> experiment_;
};

TEST_F(SafeStop, EmergencyStopHoldsUntilItIsReset) {
  walk();
  const auto cause_ns = say(scarab_OPERATOR_EMERGENCY_STOP, "a cable");
  await_stillness("emergency stop", cause_ns, kSchedulingNs);
  expect_reason("a cable");
  expect_reset_works();
}

TEST_F(SafeStop, OperatorStopEndsTheTrialWithMotorsOff) {
  walk();
  const auto cause_ns = say(scarab_OPERATOR_STOP, "lunch");
  await_stillness("operator stop", cause_ns, kSchedulingNs);
  EXPECT_TRUE(eventually([&] { return stack_->journal().first_after("torque_off", cause_ns); }));
  EXPECT_TRUE(status_.await({"robot_bridge", 0}, [](const Report& report) {
    return report.lifecycle == scarab_LIFECYCLE_INACTIVE;
  }));
}

/// Three ticks without a command are too many. The last goals are where the joints stand then.
TEST_F(SafeStop, NoCommands) {
  walk();
  const std::int64_t cause_ns = bus::now_ns();
  stack_->service("premotor").signal(SIGSTOP);
  await_stillness("no commands", cause_ns, 4 * kTickNs + kSchedulingNs);
  expect_reason("no valid joint_command for 3 ticks");
  stack_->service("premotor").signal(SIGCONT);
  expect_reset_works();
}

TEST_F(SafeStop, LostDeviceIsFoundAgain) {
  walk();
  const auto cause_ns = misbehave({"unplug", "for", "1.5"});
  await_stillness("unplugged", cause_ns, kSchedulingNs);
  expect_reason("safe stop");
  EXPECT_TRUE(eventually([&] { return stack_->journal().first_after("fault_off", cause_ns); }));
  EXPECT_TRUE(status_.await({"robot_bridge", 0}, [](const Report& report) {
    return report.counters.at("device_opened") == 2;
  })) << stack_->errors();
  expect_reset_works();
}

TEST_F(SafeStop, SilentServo) {
  walk();
  const auto cause_ns = misbehave({"silent", "FR1"});
  await_stillness("silent servo", cause_ns, 2 * kTickNs + kSchedulingNs);
  expect_reason("FR1");
  EXPECT_FALSE(stack_->journal().first_after("torque_off", cause_ns)) << "the others are to hold";
}

TEST_F(SafeStop, HotServo) {
  walk();
  const auto cause_ns = misbehave({"hot", "CL1", "75"});
  // Each reading asks one of 19 servos for its temperature or its torque: two rounds at most.
  await_stillness("hot servo", cause_ns,
                  (2 * 19 + kConfirmations) * kSensorPeriodNs + kSchedulingNs);
  expect_reason("CL1");
  // It is not to be reset as long as it is hot.
  const Finished reset = run({program("scarab-operator"), "--tag", test_tag(), "reset"});
  EXPECT_EQ(reset.exit_code, 1);
  EXPECT_THAT(reset.err, HasSubstr("reset refused: CL1"));
  EXPECT_TRUE(stack_->tell({"clear"}));
}

TEST_F(SafeStop, TooMuchCurrent) {
  walk();
  const auto cause_ns = misbehave({"current", "FL0", "6"});
  await_stillness("too much current", cause_ns, kConfirmations * kSensorPeriodNs + kSchedulingNs);
  expect_reason("FL0");
}

TEST_F(SafeStop, Inclination) {
  walk();
  const auto cause_ns = misbehave({"tilt", "1.3"});
  await_stillness("inclination", cause_ns, kConfirmations * kSensorPeriodNs + kSchedulingNs);
  expect_reason("the trunk leans");
}

TEST_F(SafeStop, ShutdownOfTheBridge) {
  walk();
  const std::int64_t cause_ns = bus::now_ns();
  EXPECT_EQ(stack_->service("robot_bridge").stop(), 0);
  await_stillness("SIGTERM of the bridge", cause_ns, kSchedulingNs);
  EXPECT_TRUE(stack_->journal().first_after("torque_off", cause_ns));
}

TEST_F(SafeStop, CrashOfTheBridge) {
  walk();
  const std::int64_t cause_ns = bus::now_ns();
  stack_->service("robot_bridge").signal(SIGSEGV);
  EXPECT_EQ(stack_->service("robot_bridge").wait(std::chrono::seconds(10)), 128 + SIGSEGV);
  await_stillness("crash of the bridge", cause_ns, kSchedulingNs);
  EXPECT_TRUE(eventually([&] { return stack_->journal().first_after("torque_off", cause_ns); }))
      << "its last words did not switch the motors off";
}

/// Nobody is left to say a word: the servos' own watchdog.
TEST_F(SafeStop, KilledBridge) {
  walk();
  const std::int64_t cause_ns = bus::now_ns();
  stack_->service("robot_bridge").kill();
  await_stillness("kill -9 of the bridge", cause_ns, kSchedulingNs);
  std::optional<WireJournal::Event> watchdog;
  ASSERT_TRUE(eventually([&] {
    watchdog = stack_->journal().first_after("watchdog", cause_ns);
    return watchdog.has_value();
  }));
  const std::int64_t after_ns = watchdog->stamp_ns - cause_ns;
  std::cout << "the servos stop by themselves " << static_cast<double>(after_ns) / kMs
            << " ms after it\n";
  EXPECT_LE(after_ns, 200 * kMs + kSchedulingNs);  // bus_watchdog_s
}

/// Nothing that was refused reaches a servo: a second, other answer to every tick.
TEST_F(SafeStop, RefusedCommandsReachNoServo) {
  walk();
  bus::Writer<scarab_JointCommand> commands(participant_, bus::kJointCommand);
  bus::Reader<scarab_RobotState> states(participant_, bus::kRobotState);
  ASSERT_TRUE(eventually([&] { return !commands.matched().empty(); }));
  const std::int64_t begin_ns = bus::now_ns();
  constexpr double kNowhere_rad = 0.7654;
  unsigned sent = 0;
  ASSERT_TRUE(eventually([&] {
    states.take([&](const scarab_RobotState& state) {
      scarab_JointCommand command{};
      command.header = state.header;
      command.header.tick += sent % 2 == 0 ? 1000 : 0;  // from the future, or of another trial
      command.header.trial += sent % 2 == 0 ? 0 : 7;
      command.kind = scarab_COMMAND_POSITION;
      std::fill(std::begin(command.position_rad), std::end(command.position_rad), kNowhere_rad);
      commands.write(command);
      ++sent;
    });
    return sent >= 20;
  }));
  const auto report = status_.await({"robot_bridge", 0}, [](const Report& r) {
    return r.counters.at("commands_refused_future") >= 9 &&
           r.counters.at("commands_refused_trial") >= 9;
  });
  EXPECT_TRUE(report) << stack_->errors();
  const WireJournal journal = stack_->journal();
  for (const auto& event : journal.events()) {
    if (event.name != "goal" || event.stamp_ns < begin_ns) continue;
    EXPECT_THAT(event.detail, testing::Not(HasSubstr("0.765")));
  }
}

}  // namespace
}  // namespace scarab::test
