#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "common/bus/raw_writer.hpp"
#include "common/bus/topics.hpp"
#include "common/bus/writer.hpp"
#include "tests/integration/types/any_endpoint.hpp"
#include "tests/support/child_process.hpp"
#include "tests/support/files.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/test_bus.hpp"

namespace scarab::test {

/// Runs scarab-topic beside a participant of the test that calls itself plant/0.
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

  /// Starts it; `input` is a file for its standard input.
  ChildProcess start_topic(const Arguments& words,
                           const std::filesystem::path& input = "/dev/null") {
    return {command(words), directory_ / ("topic-" + std::to_string(++started_)), input};
  }

  /// A command with its topic, `more` and a short patience must end with this code, one line on
  /// stderr that has `reason` in it, and nothing on stdout.
  static void expect_refused(int exit_code, const Arguments& words, const std::string& reason) {
    const Finished result = topic(words);
    EXPECT_EQ(result.exit_code, exit_code) << result.out << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(result.err, testing::HasSubstr(reason));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  }

  TemporaryDirectory directory_;
  bus::Participant plant_{test_options("plant")};

 private:
  int started_ = 0;
};

/// A joint command of this tick.
inline scarab_JointCommand joint_command(std::uint32_t tick) {
  scarab_JointCommand sample{};
  sample.header.tick = tick;
  return sample;
}

/// The type of the project's own topics under another name, or without type information: what a
/// foreign vendor's writer looks like.
inline bus::TopicType disguised(const dds_topic_descriptor_t& d, const char* name,
                                bool with_information) {
  const std::uint32_t flags =
      with_information ? d.m_flagset : d.m_flagset & ~DDS_TOPIC_XTYPES_METADATA;
  const dds_type_meta_ser none{nullptr, 0};
  const auto made = std::make_shared<dds_topic_descriptor_t>(dds_topic_descriptor_t{
      d.m_size, d.m_align, flags, d.m_nkeys, name, d.m_keys, d.m_nops, d.m_ops, d.m_meta,
      with_information ? d.type_information : none, with_information ? d.type_mapping : none,
      d.restrict_data_representation});
  return made;
}

}  // namespace scarab::test
