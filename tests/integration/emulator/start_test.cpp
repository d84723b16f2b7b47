#include <gmock/gmock.h>

#include <csignal>

#include "tests/integration/emulator/emulator_process.hpp"
#include "tests/integration/emulator/line.hpp"

/// How the emulator begins and ends.
namespace scarab::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

bool is_there(const fs::path& path) { return fs::exists(fs::symlink_status(path)); }

TEST(EmulatorStart, SaysWhatItIsAndWhereAndLeavesNothingBehind) {
  EmulatorProcess emulator;
  EXPECT_TRUE(eventually(
      [&] { return emulator.child().err().find("19 DYNAMIXEL servos") != std::string::npos; }));
  EXPECT_THAT(emulator.child().err(),
              AllOf(HasSubstr(emulator.device().string()), HasSubstr("at 1000000 baud"),
                    HasSubstr("scarab-emulator tell")));
  EXPECT_TRUE(fs::is_symlink(emulator.device()));
  EXPECT_EQ(emulator.child().stop(), 0);
  for (const char* name : {"device", "device.lock", "emulator"}) {
    EXPECT_FALSE(is_there(emulator.run_dir() / name)) << name;
  }
}

TEST(EmulatorStart, RefusesTheDeviceOfALivingOne) {
  EmulatorProcess emulator;
  emulator.tell("tilt 0.1");
  const Finished second = run(emulator_command(emulator.run_dir()));
  EXPECT_EQ(second.exit_code, 1);
  EXPECT_THAT(second.err, HasSubstr("another emulator has this device"));
  EXPECT_THAT(emulator.journal(), HasSubstr("fault_on,tilt")) << "its journal is unharmed";
  DynamixelLine line(emulator.device());
  EXPECT_TRUE(line.ask(dxl::ping(1))) << "the first one is unharmed";
}

TEST(EmulatorStart, RefusesTheControlPipeOfALivingOne) {
  EmulatorProcess emulator;
  const TemporaryDirectory elsewhere;
  Arguments command = emulator_command(elsewhere.path());
  command.insert(command.end(), {"--control", emulator.run_dir() / "emulator"});
  const Finished second = run(command);
  EXPECT_EQ(second.exit_code, 1);
  EXPECT_THAT(second.err, HasSubstr("another emulator takes its faults here"));
  EXPECT_FALSE(is_there(elsewhere / "device"));
  emulator.tell("tilt 0.1");
}

TEST(EmulatorStart, TakesOverFromADeadOne) {
  const TemporaryDirectory run_dir;
  const fs::path device = run_dir / "device";
  {
    ChildProcess dead(emulator_command(run_dir.path()), run_dir / "dead");
    ASSERT_TRUE(eventually([&] { return is_there(device); })) << dead.err();
    dead.kill();
  }
  ASSERT_TRUE(is_there(device)) << "it had no time to tidy up";
  ChildProcess living(emulator_command(run_dir.path()), run_dir / "living");
  // The old link may lead somewhere by now: numbers of pseudo-terminals are given out again.
  ASSERT_TRUE(eventually([&] { return living.err().find("servos") != std::string::npos; }))
      << living.err();
  DynamixelLine line(device);
  EXPECT_TRUE(line.ask(dxl::ping(1))) << living.err();
}

TEST(EmulatorStart, LeavesAloneWhatIsNoLink) {
  const TemporaryDirectory run_dir;
  write_text(run_dir / "device", "precious");
  const Finished refused = run(emulator_command(run_dir.path()));
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, HasSubstr("something that is no link"));
  EXPECT_EQ(read_text(run_dir / "device"), "precious");
}

TEST(EmulatorStart, ChecksItsFilesFirst) {
  const TemporaryDirectory run_dir;
  const auto with = [&](const Arguments& more) {
    Arguments command = emulator_command(run_dir.path());
    command.insert(command.end(), more.begin(), more.end());
    return run(command);
  };
  EXPECT_EQ(with({"--check"}).exit_code, 0);
  EXPECT_FALSE(is_there(run_dir / "device"));
  const Finished dumped = with({"--dump-config"});
  EXPECT_EQ(dumped.exit_code, 0);
  EXPECT_THAT(dumped.out, HasSubstr("driver: dynamixel"));
  const Finished faulty = with({"--fault", "stuck"});
  EXPECT_EQ(faulty.exit_code, 2);
  EXPECT_THAT(faulty.err, HasSubstr("stuck needs a joint"));
  const Finished loopback = run(emulator_command(run_dir.path(), "loopback"));
  EXPECT_EQ(loopback.exit_code, 2);
  EXPECT_THAT(loopback.err, HasSubstr("no board to emulate for the driver loopback"));
}

}  // namespace
}  // namespace scarab::test
