#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/support/files.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/test_bus.hpp"
#include "tests/system/stack.hpp"

namespace scarab::test {

/// A directory for logs, and the log tool on the running test's tag.
class ReplayTest : public testing::Test {
 protected:
  /// `scarab-log replay LOG ...`, to its end.
  Finished replay(const std::filesystem::path& log, const Arguments& more) {
    return run(replay_command(log, more), std::chrono::seconds(60));
  }
  /// The same beside the test.
  ChildProcess start_replay(const std::filesystem::path& log, const Arguments& more) {
    return {replay_command(log, more), directory_ / "replay"};
  }

  TemporaryDirectory directory_;

 private:
  static Arguments replay_command(const std::filesystem::path& log, const Arguments& more) {
    Arguments command = {program("scarab-log"), "replay", log, "--tag", test_tag()};
    command.insert(command.end(), more.begin(), more.end());
    return command;
  }
};

}  // namespace scarab::test
