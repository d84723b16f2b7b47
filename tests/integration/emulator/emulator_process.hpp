#pragma once

#include <gmock/gmock.h>

#include <filesystem>
#include <sstream>
#include <string>

#include "tests/support/child_process.hpp"
#include "tests/support/eventually.hpp"
#include "tests/support/files.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/test_bus.hpp"

namespace scarab::test {

/// The emulator of a driver's board with the shipped files of the beetle, on the test's own tag.
inline Arguments emulator_command(const std::filesystem::path& run_dir,
                                  const std::string& driver = "dynamixel") {
  return {program("scarab-emulator"),
          "--robot",
          source_file("config/robot/beetle.yaml"),
          "--plant",
          source_file("config/plant/beetle.yaml"),
          "--config",
          source_file("config/robot_bridge/beetle-" + driver + ".yaml"),
          "--run-dir",
          run_dir,
          "--journal",
          run_dir / "journal.csv",
          "--tag",
          test_tag()};
}

/// One that runs, and what it leaves in its run directory.
class EmulatorProcess {
 public:
  explicit EmulatorProcess(const std::string& driver = "dynamixel", const Arguments& more = {})
      : child_(command(run_dir_.path(), driver, more), run_dir_ / "emulator-0") {
    EXPECT_TRUE(eventually([&] { return std::filesystem::exists(device()) || !child_.running(); }));
    EXPECT_TRUE(child_.running()) << child_.err();
  }

  [[nodiscard]] std::filesystem::path device() const { return run_dir_ / "device"; }
  [[nodiscard]] const std::filesystem::path& run_dir() const { return run_dir_.path(); }
  [[nodiscard]] ChildProcess& child() { return child_; }
  [[nodiscard]] std::string journal() const { return read_text(run_dir_ / "journal.csv"); }
  /// Waits for a line of the journal with this text.
  [[nodiscard]] bool notes(const std::string& text) {
    return eventually([&] { return journal().find(text) != std::string::npos; });
  }
  /// scarab-emulator tell, and waits until it has had its effect.
  void tell(const std::string& fault) {
    const std::string before = journal();
    Arguments command = {program("scarab-emulator"), "tell", run_dir_.path()};
    std::istringstream words(fault);
    for (std::string word; words >> word;) command.push_back(word);
    const Finished told = run(command);
    ASSERT_EQ(told.exit_code, 0) << told.err;
    ASSERT_TRUE(eventually([&] { return journal() != before; })) << fault << child_.err();
  }

 private:
  static Arguments command(const std::filesystem::path& run_dir, const std::string& driver,
                           const Arguments& more) {
    Arguments all = emulator_command(run_dir, driver);
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  TemporaryDirectory run_dir_;
  ChildProcess child_;
};

}  // namespace scarab::test
