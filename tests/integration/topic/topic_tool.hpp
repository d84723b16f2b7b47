#pragma once

#include <gtest/gtest.h>

#include <string>

#include "common/bus/participant.hpp"
#include "tests/support/child_process.hpp"
#include "tests/support/files.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/test_bus.hpp"

namespace scarab::test {

/// Runs scarab-topic beside participants of the test.
class TopicTool : public testing::Test {
 protected:
  /// The command line for words such as {"echo", "scarab/trial"}.
  static Arguments command(const Arguments& words) {
    Arguments all = {program("scarab-topic")};
    all.insert(all.end(), words.begin(), words.end());
    all.insert(all.end(), {"--tag", test_tag()});
    return all;
  }

  /// Runs it to its end.
  static Finished topic(const Arguments& words) { return run(command(words)); }

  /// Starts it; its output is in a file of its own. `input`: a file for standard input.
  ChildProcess start_topic(const Arguments& words,
                           const std::filesystem::path& input = "/dev/null") {
    return {command(words), directory_ / ("topic-" + std::to_string(++started_)), input};
  }

  TemporaryDirectory directory_;

 private:
  int started_ = 0;
};

}  // namespace scarab::test
