#include "tests/system/launcher_rig.hpp"
#include "tests/system/trial_log.hpp"
#include "tests/system/two_hosts.hpp"

namespace scarab::test {
namespace {

using testing::HasSubstr;

/// The launcher on either of two hosts, with the shipped profiles.
class LauncherOnTwoHosts : public Launcher {
 protected:
  [[nodiscard]] Finished on(const Host& host, const Arguments& words,
                            const std::string& runs) const {
    const Arguments places = {"--domain", "0",
                              "--bin",    std::filesystem::path(program("x")).parent_path(),
                              "--runs",   runs_ / runs};
    return run(host.enter + Arguments{source_file("deploy/scarab")} + words + places, kRunLimit);
  }
};

TEST_F(LauncherOnTwoHosts, EachStartsItsOwnAndTheTrialRunsOnBoth) {
  const TwoHosts hosts(TwoHosts::Multicast::kOn);
  const Arguments cable = {"--interface", TwoHosts::kInterface};
  const auto plant =
      on(hosts.first(), Arguments{"up", "--profile", "plant-host", "--lockstep"} + cable, "plant");
  EXPECT_EQ(plant.exit_code, 0) << plant.err;
  EXPECT_THAT(plant.out, HasSubstr("not yet: logger/0 is missing, premotor/0 is missing"));
  const auto control =
      on(hosts.second(), Arguments{"up", "--profile", "control-host", "--lockstep"} + cable,
         "control");
  EXPECT_EQ(control.exit_code, 0) << control.err;
  EXPECT_THAT(control.out, HasSubstr("elsewhere: plant=1, all there"));
  const auto trial = on(hosts.second(), Arguments{"run", "--no-figure"} + kSuccess, "control");
  EXPECT_EQ(trial.exit_code, 0) << trial.out << trial.err;
  EXPECT_EQ(on(hosts.first(), {"down"}, "plant").exit_code, 0);
  EXPECT_EQ(on(hosts.second(), {"down"}, "control").exit_code, 0);
  EXPECT_THAT(living(), testing::IsEmpty());
}

/// The bridge on the robot's computer, with an emulated robot at its wire; all else on another.
TEST_F(LauncherOnTwoHosts, ARobotIsDrivenFromAnotherHost) {
  const TwoHosts hosts(TwoHosts::Multicast::kOn);
  const Arguments cable = {"--interface", TwoHosts::kInterface};
  const auto robot =
      on(hosts.first(),
         Arguments{"up", "--profile", "robot-host", "--driver", "dynamixel", "--emulated"} + cable,
         "robot");
  ASSERT_EQ(robot.exit_code, 0) << robot.err;
  EXPECT_THAT(robot.out, HasSubstr("in real time: robot_bridge=1\nemulated hardware: emulator=1"));
  EXPECT_THAT(robot.out, HasSubstr("elsewhere: logger=1,supervisor=1,premotor=1; not yet"));
  const auto trial =
      on(hosts.second(),
         Arguments{"run", "--no-figure", "--profile", "robot-control-host"} + cable + kSuccess,
         "control");
  EXPECT_EQ(trial.exit_code, 0) << trial.out << trial.err;
  // 3 s at 10 Hz and the tick of the verdict.
  const auto log = read_trial(runs_ / "control" / "latest" / "trial.mcap");
  EXPECT_TRUE(contiguous_from_zero(log.ticks));
  EXPECT_EQ(log.ticks.size(), 31U);
  const auto doctor = on(hosts.first(), {"doctor", "device"}, "robot");
  EXPECT_EQ(doctor.exit_code, 0) << doctor.out;
  EXPECT_THAT(doctor.out, HasSubstr("an emulated robot, is open in robot_bridge of the stack"));
  EXPECT_EQ(on(hosts.first(), {"down"}, "robot").exit_code, 0);
  EXPECT_THAT(living(), testing::IsEmpty());
}

}  // namespace
}  // namespace scarab::test
