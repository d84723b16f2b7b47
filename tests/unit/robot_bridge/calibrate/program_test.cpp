#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "tests/support/eventually.hpp"
#include "tests/support/files.hpp"
#include "tests/support/programs.hpp"

/// scarab-calibrate as a process, on the loopback driver.
namespace scarab::test {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class CalibrateProgram : public testing::Test {
 protected:
  CalibrateProgram() {
    // TL0's servo sits 0.3 rad off and runs the other way; the calibration knows of neither.
    std::string config = read_text(source_file("config/robot_bridge/beetle-loopback.yaml"));
    const std::string section = "loopback: {}";
    const std::size_t at = config.find(section);
    EXPECT_NE(at, std::string::npos);
    config.replace(at, section.size(),
                   "loopback: {mounting: {TL0: {offset_rad: 0.3, direction: -1}}}");
    const std::string shipped = "../calibration/beetle-loopback.yaml";
    config.replace(config.find(shipped), shipped.size(), "calibration.yaml");
    write_text(config_, config);
    std::filesystem::copy_file(source_file("config/calibration/beetle-loopback.yaml"), file_);
  }

  [[nodiscard]] Arguments command(const Arguments& more) const {
    Arguments all = {program("scarab-calibrate"), "--robot",
                     source_file("config/robot/beetle.yaml"), "--config", config_};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  TemporaryDirectory directory_;
  std::filesystem::path config_ = directory_ / "bridge.yaml";
  std::filesystem::path file_ = directory_ / "calibration.yaml";
};

TEST_F(CalibrateProgram, TakesThePresentPoseAndThenFindsTheFileRight) {
  const Finished before = run(command({"--check", "--yes"}));
  EXPECT_EQ(before.exit_code, 1);
  EXPECT_THAT(before.out, AllOf(HasSubstr("TL0: +0.300 rad (+17.2 deg) where it should be +0.000"),
                                HasSubstr("1 of 19 joints are off")));
  const Finished taken = run(command({"--yes"}));
  EXPECT_EQ(taken.exit_code, 0) << taken.err;
  EXPECT_THAT(taken.out, HasSubstr("19 of 19 joints written"));
  EXPECT_THAT(read_text(file_), AllOf(HasSubstr("TL0: {offset_rad: 0.3000, direction: 1,"),
                                      HasSubstr("# The beetle without a device")))
      << "comments stay";
  const Finished after = run(command({"--check", "--yes"}));
  EXPECT_EQ(after.exit_code, 0) << after.out;
}

TEST_F(CalibrateProgram, TouchesOnlyTheJointsItWasAskedFor) {
  const std::string before = read_text(file_);
  EXPECT_EQ(run(command({"--yes", "--joints", "CL0,FR2", "--pose", "start"})).exit_code, 0);
  const std::string after = read_text(file_);
  const auto line_of = [](const std::string& text, const std::string& joint) {
    const std::size_t at = text.find("\n" + joint + ":");
    return text.substr(at, text.find('\n', at + 1) - at);
  };
  EXPECT_EQ(line_of(after, "TL0"), line_of(before, "TL0"));
  EXPECT_THAT(line_of(after, "CL0"), HasSubstr("offset_rad: 0.2040"));
  EXPECT_THAT(line_of(after, "FR2"), HasSubstr("start pose"));
}

TEST_F(CalibrateProgram, ShowsWhatIsDoneAndStopsWhenTheInputEnds) {
  const Finished done = run(command({}));
  EXPECT_EQ(done.exit_code, 0);
  EXPECT_THAT(done.out, HasSubstr("All 19 joints have an entry"));
  const std::string before = read_text(file_);
  const Finished ended = run(command({"--again"}));  // stdin: /dev/null
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_THAT(ended.out, AllOf(HasSubstr("TL0: put it so: leg straight out sideways"),
                               HasSubstr("0 of 19 joints written")));
  EXPECT_EQ(read_text(file_), before);
}

TEST_F(CalibrateProgram, IsInterruptedWithItsOwnExitCode) {
  const std::filesystem::path keys = directory_ / "keys";
  ASSERT_EQ(mkfifo(keys.c_str(), 0600), 0);
  const int writer = open(keys.c_str(), O_RDWR | O_CLOEXEC);  // so that the input does not end
  ASSERT_GE(writer, 0);
  ChildProcess tool(command({"--again"}), directory_ / "tool", keys);
  ASSERT_TRUE(eventually([&] { return tool.out().find("put it so") != std::string::npos; }, 20s));
  tool.signal(SIGINT);
  EXPECT_EQ(tool.wait(20s), 130);
  EXPECT_THAT(tool.err(), HasSubstr("interrupted"));
  close(writer);
}

TEST_F(CalibrateProgram, RefusesWhatCannotBeDone) {
  const auto refusal = [&](const Arguments& more) {
    const Finished finished = run(command(more));
    EXPECT_EQ(finished.exit_code, 2) << finished.out;
    EXPECT_THAT(finished.out, Not(HasSubstr("Robot found")));
    return finished.err;
  };
  EXPECT_THAT(refusal({"--joints", "TL9"}), HasSubstr("no joint TL9"));
  EXPECT_THAT(refusal({"--pose", "sitting"}), HasSubstr("--pose"));
  EXPECT_THAT(refusal({"--yes", "--output", directory_ / "new.yaml"}),
              HasSubstr("TL0 has no entry"));
}

TEST_F(CalibrateProgram, ARobotWithoutAnglesIsNotAskedForThem) {
  Arguments all = {program("scarab-calibrate"),
                   "--robot",
                   source_file("config/robot/beetle.yaml"),
                   "--config",
                   source_file("config/robot_bridge/beetle-amosii.yaml"),
                   "--device",
                   "/dev/ttyNotThere0"};
  all.emplace_back("--yes");
  const Finished asked = run(all);
  EXPECT_EQ(asked.exit_code, 2);
  EXPECT_THAT(asked.err, HasSubstr("does not tell where its joints are"));
  all.back() = "--again";
  const Finished not_there = run(all);
  EXPECT_EQ(not_there.exit_code, 1);
  EXPECT_THAT(not_there.err, HasSubstr("/dev/ttyNotThere0: no such device"));
}

}  // namespace
}  // namespace scarab::test
