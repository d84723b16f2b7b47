#include <pty.h>
#include <unistd.h>

#include <csignal>
#include <regex>

#include "tests/support/eventually.hpp"
#include "tests/support/test_bus.hpp"
#include "tests/system/launcher_rig.hpp"
#include "tests/system/trial_log.hpp"

namespace scarab::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The profile `robot`: the bridge in the plant's place, and an emulator in the robot's.
class LauncherRobot : public Launcher {
 protected:
  static inline const Arguments kRobot = {"--profile", "robot", "--driver", "dynamixel"};
  static inline const Arguments kEmulated = {"--profile", "robot", "--driver", "dynamixel",
                                             "--emulated"};

  /// The processes that an event of the launcher's log names, in its order.
  [[nodiscard]] std::vector<std::string> named_by(const std::string& event) const {
    const std::string log = read_text(run_directory() / "logs" / "launcher.log");
    const std::regex pattern(event + " service=(\\w+)");
    std::vector<std::string> names;
    for (std::sregex_iterator it(log.begin(), log.end(), pattern), end; it != end; ++it) {
      names.push_back((*it)[1]);
    }
    return names;
  }
  [[nodiscard]] Finished status() const { return run(scarab({"status"}), kRunLimit); }
};

TEST_F(LauncherRobot, EmulatedRunLeavesWhatARunOfThePlantLeaves) {
  const auto result =
      run(scarab(Arguments{"run", "--tag", test_tag()} + kEmulated + kSuccess), kRunLimit);
  ASSERT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_THAT(result.out, HasSubstr("result: success"));
  const auto directory = run_directory();
  for (const auto* name :
       {"trial.mcap", "results.csv", "figure7.svg", "figure7.csv", "config/robot_bridge.yaml",
        "config/plant.yaml", "config/calibration-beetle-dynamixel.yaml", "config/robot-beetle.yaml",
        "config/premotor.yaml", "config/supervisor.yaml", "logs/robot_bridge.log",
        "logs/emulator.log"}) {
    EXPECT_TRUE(fs::is_regular_file(directory / name) && fs::file_size(directory / name) > 0)
        << name;
  }
  const auto trial = read_trial(directory / "trial.mcap");
  EXPECT_TRUE(contiguous_from_zero(trial.ticks));
  EXPECT_EQ(trial.ticks.size(), 31U);  // 3 s at 10 Hz and the tick of the verdict
  EXPECT_THAT(read_text(directory / "results.csv"),
              testing::ContainsRegex(",(0[.]9[0-9]|1[.]0[0-9]),"))
      << "x real time";
  EXPECT_THAT(named_by("started"),
              ElementsAre("emulator", "logger", "robot_bridge", "supervisor", "premotor"));
  EXPECT_THAT(named_by("stopped"),
              ElementsAre("premotor", "supervisor", "robot_bridge", "logger", "emulator"));
  EXPECT_THAT(living(), IsEmpty());
  const auto attachments = run({program("scarab-log"), "attachments", directory / "trial.mcap"});
  EXPECT_THAT(attachments.out, HasSubstr("config/calibration-beetle-dynamixel.yaml"));
}

TEST_F(LauncherRobot, EmulatedRobotIsUnpluggedAndKilledAndFoundAgain) {
  up(kEmulated);
  const auto tell = [&](const std::string& word) {
    return run(tool({"emulator", "tell", "latest", word})).exit_code;
  };
  ASSERT_EQ(tell("unplug"), 0);
  EXPECT_TRUE(eventually([&] { return status().out.find("unconfigured") != std::string::npos; }))
      << status().out;
  EXPECT_EQ(tell("clear"), 0);
  EXPECT_TRUE(eventually([&] { return status().exit_code == 0; })) << status().out;
  EXPECT_EQ(tell("sulk"), 2);
  ::kill(pid_of(run_directory(), "emulator"), SIGKILL);
  const auto crashes = run_directory() / "pids" / "emulator.crashes";
  EXPECT_TRUE(
      eventually([&] { return read_text(crashes).find("\"restarts\": 1") != std::string::npos; }));
  EXPECT_TRUE(eventually([&] { return status().exit_code == 0; })) << status().out;
  const auto next =
      run(scarab({"run", "--no-figure", "--goal", "none", "--time-limit", "1"}), kRunLimit);
  EXPECT_EQ(next.exit_code, 0) << next.out << next.err;
}

TEST_F(LauncherRobot, PortWhereNobodyAnswersIsWaitedForAndSaid) {
  int ours = -1;
  int other = -1;
  char name[64];
  ASSERT_EQ(::openpty(&ours, &other, name, nullptr, nullptr), 0);
  ::close(other);  // or the port is in use
  ChildProcess child(scarab(Arguments{"up", "--tag", test_tag(), "--device", name} + kRobot),
                     directory_ / "up");
  EXPECT_TRUE(eventually([&] {
    return child.err().find("waits: robot_bridge/0 is not configured: ") != std::string::npos;
  })) << child.output();
  ::kill(-child.pid(), SIGINT);
  EXPECT_EQ(child.wait(kRunLimit), 130) << child.output();
  ::close(ours);
  EXPECT_THAT(living(), IsEmpty());
}

TEST_F(LauncherRobot, PortThatIsNotThereStartsNothing) {
  const auto result =
      run(scarab_run(kRobot + kSuccess + Arguments{"--device", "/dev/no-such"}), kRunLimit);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("there is no /dev/no-such"));
  EXPECT_FALSE(fs::exists(runs_));
}

}  // namespace
}  // namespace scarab::test
