/// What two logs have in common.
#include "tools/log/comparison.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <sstream>

#include "tests/unit/log/behaviour_log.hpp"
#include "tests/unit/mcap/temporary_folder.hpp"
#include "tools/log/comparison_report.hpp"

namespace scarab::log::test {
namespace {

using mcap::test::TemporaryFolder;
using testing::HasSubstr;

class Compare : public testing::Test {
 protected:
  using Samples = std::vector<scarab_Behaviour>;

  /// Two logs of trials 1 and 2 with ten ticks each, the second after `change` has been at its
  /// samples.
  TopicComparison compare(const std::function<void(Samples&)>& change,
                          const Lenience& lenience = {}) {
    const TemporaryFolder folder;
    Samples samples;
    for (std::uint32_t i = 0; i < 20; ++i) samples.push_back(behaviour(1 + i / 10, i % 10, i));
    write(folder / "a.mcap", samples);
    for (auto& sample : samples) sample.header.stamp_ns += 1000;
    change(samples);
    write(folder / "b.mcap", samples);
    return compare_topic(Log(folder / "a.mcap"), Log(folder / "b.mcap"), "scarab/behaviour",
                         lenience);
  }
  std::string first(const std::function<void(Samples&)>& change, const Lenience& lenience = {}) {
    const auto result = compare(change, lenience);
    return result.first ? to_string(*result.first, "a", "b") : "";
  }

 private:
  static void write(const std::filesystem::path& path, const Samples& samples) {
    LogWriter log(path);
    for (const auto& sample : samples) log.write(sample);
    log.close();
  }
};

TEST_F(Compare, WallClockStampsDoNotCount) {
  const auto result = compare([](Samples&) {});
  EXPECT_TRUE(result.is_equal());
  EXPECT_EQ(result.equal, 20U);
}

TEST_F(Compare, NamesTheFirstFieldThatDiffersAndCountsOn) {
  const auto change = [](Samples& samples) {
    samples[13].inputs[2] = 0.25;
    samples[17].mode = scarab_MODE_STOP;
  };
  const auto result = compare(change);
  EXPECT_EQ(result.equal, 18U);
  EXPECT_EQ(result.different, 2U);
  EXPECT_EQ(first(change), "trial 2, tick 3 (0.3 s): inputs[2]: 0 and 0.25");
  EXPECT_EQ(first([](Samples& samples) { samples[4].mode = scarab_MODE_STOP; }),
            "trial 1, tick 4 (0.4 s): mode: \"MODE_BACKWARD\" and \"MODE_STOP\"");
}

TEST_F(Compare, ASampleThatOneLogLacksIsADifference) {
  EXPECT_EQ(first([](Samples& samples) { samples.pop_back(); }),
            "trial 2, tick 9 (0.9 s): only in a");
  const auto gap = [](Samples& samples) { samples.erase(samples.begin() + 2); };
  EXPECT_EQ(first(gap), "trial 1, tick 2 (0.2 s): only in a");
  EXPECT_EQ(compare(gap).equal, 19U) << "those after the gap are compared as well";
  EXPECT_EQ(first([](Samples& samples) { samples.push_back(behaviour(3, 0, 0)); }),
            "trial 3, tick 0 (0 s): only in b");
}

TEST_F(Compare, TheSameAnswerGivenTwiceCountsOnceAndOrderOfReceptionNot) {
  EXPECT_TRUE(compare([](Samples& samples) {
                samples.insert(samples.begin() + 5, samples[4]);  // a restarted service's
                std::swap(samples[0], samples[15]);
              }).is_equal());
  EXPECT_EQ(first([](Samples& samples) {
              samples.insert(samples.begin() + 5, samples[4]);
              samples[5].as_rad = 1;  // another answer to the same tick
            }),
            "trial 1, tick 4 (0.4 s): only in b");
}

TEST_F(Compare, FieldsCanBeIgnored) {
  const auto change = [](Samples& samples) {
    samples[3].inputs[2] = 0.25;
    bus::assign(samples[5].reason, "runs");
  };
  EXPECT_EQ(first(change, {{"inputs"}, 0}),
            "trial 1, tick 5 (0.5 s): reason: \"walks, \\\"slowly\\\"\" and \"runs\"");
  EXPECT_EQ(first(change, {{"inputs[2]", "reason"}, 0}), "");
  EXPECT_NE(first(change, {{"inputs[1]", "reason"}, 0}), "");
}

TEST_F(Compare, NumbersMayDifferByTheTolerance) {
  const auto change = [](Samples& samples) { samples[3].as_rad = 1e-9; };
  EXPECT_NE(first(change), "");
  EXPECT_EQ(first(change, {{}, 1e-9}), "");
  EXPECT_NE(first(change, {{}, 0.9e-9}), "");
  EXPECT_NE(first([](Samples& samples) { samples[3].mode = scarab_MODE_STOP; }, {{}, 100}), "")
      << "names are no numbers";
}

/// Two logs of a topic without header.
class CompareMeadow : public testing::Test {
 protected:
  using Patches = std::vector<std::vector<std::uint8_t>>;
  void write(const std::string& name, const Patches& patches) {
    LogWriter log(folder_ / name);
    const auto channel = log.add_channel("meadow", "meadow::Patch", "omgidl", kMeadowIdl);
    std::uint64_t time = kSecond;
    for (const auto& bytes : patches) log.write(channel, time++, bytes);
    log.close();
  }
  std::string first() {
    const auto result = compare_topic(Log(folder_ / "a.mcap"), Log(folder_ / "b.mcap"), "meadow");
    return result.first ? to_string(*result.first, "a", "b") : "";
  }
  TemporaryFolder folder_;
};

TEST_F(CompareMeadow, SamplesOfAnyTypeAreComparedInTheOrderOfTheirPublication) {
  write("a.mcap", {patch(1, {}), patch(2, {7})});
  write("b.mcap", {patch(1, {}), patch(2, {7})});
  EXPECT_EQ(first(), "");
  write("c.mcap", {patch(1, {}), patch(2, {7, 8})});
  std::filesystem::rename(folder_ / "c.mcap", folder_ / "b.mcap");
  EXPECT_THAT(first(), HasSubstr("sample 1 (published at 1970-01-01 00:00:01.000 UTC): "
                                 "flowers.length: 1 and 2"));
  write("d.mcap", {patch(1, {})});
  std::filesystem::rename(folder_ / "d.mcap", folder_ / "b.mcap");
  EXPECT_THAT(first(), HasSubstr("only in a"));
}

TEST_F(CompareMeadow, ReportsAsTextAndAsJson) {
  write("a.mcap", {patch(1, {}), patch(2, {7})});
  write("b.mcap", {patch(1, {}), patch(3, {7})});
  const Log a(folder_ / "a.mcap");
  const Log b(folder_ / "b.mcap");
  const LogComparison comparison{"A", "B", {compare_topic(a, b, "meadow")}};
  std::ostringstream text;
  print_text(comparison, text);
  EXPECT_EQ(text.str(),
            "meadow: 1 of 2 samples equal, 1 different\n"
            "  first: sample 1 (published at 1970-01-01 00:00:01.000 UTC): area_m2: 2 and 3\n"
            "summary: 1 of 1 topic different, 1 of 2 samples equal\n");
  std::ostringstream json;
  print_json(comparison, json);
  EXPECT_THAT(json.str(), HasSubstr("\"equal\": false"));
  EXPECT_THAT(json.str(), HasSubstr("\"field\": \"area_m2\", \"a\": 2, \"b\": 3"));
}

}  // namespace
}  // namespace scarab::log::test
