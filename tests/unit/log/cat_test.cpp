/// Messages as text.
#include "tools/log/cat.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <stdexcept>

#include "common/sample/sample_text.hpp"
#include "tests/unit/log/behaviour_log.hpp"
#include "tests/unit/mcap/temporary_folder.hpp"

namespace scarab::log::test {
namespace {

using mcap::test::TemporaryFolder;
using testing::HasSubstr;

class Cat : public testing::Test {
 protected:
  Cat() {
    LogWriter log(folder_ / "x.mcap");
    log.write(behaviour(1, 0, 5));
    const auto meadow = log.add_channel("meadow", "meadow::Patch", "omgidl", kMeadowIdl);
    log.write(meadow, 7, patch(2.5, {7}));
    log.write(log.writer().add_channel(0, "noise", "cdr"), 8, std::string_view("\x01\xff"));
    log.write(log.add_channel("ros", "std_msgs/msg/Bool", "ros2idl", "..."), 9,
              std::string_view("\x01"));
    log.write(behaviour(2, 1, 6));
    log.close();
  }
  std::string cat(const SelectionOptions& selected, const CatOptions& options) const {
    const Log log(folder_ / "x.mcap");
    std::ostringstream out;
    print_messages(log, Selection(log, selected), options, out);
    return out.str();
  }
  TemporaryFolder folder_;
};

TEST_F(Cat, PrintsALineOfJsonAMessageInTheOrderOfTheLog) {
  const std::string text = cat({}, {true, {}});
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 5);
  EXPECT_THAT(text, HasSubstr("{\"topic\":\"meadow\",\"sequence\":1,\"log_time_ns\":\"2000000000\","
                              "\"publish_time_ns\":\"7\",\"value\":{\"area_m2\": 2.5, "
                              "\"flowers\": [7], \"kind\": \"CLOVER\"}}\n"));
  EXPECT_LT(text.find("\"tick\": 0"), text.find("meadow"));
  EXPECT_LT(text.find("meadow"), text.find("\"tick\": 1"));
}

TEST_F(Cat, ShowsAsBytesWhatItHasNoTypeFor) {
  const std::string text = cat({}, {true, {}});
  EXPECT_THAT(text, HasSubstr("\"topic\":\"noise\",\"sequence\":2,\"log_time_ns\":\"3000000000\","
                              "\"publish_time_ns\":\"8\",\"bytes\":\"01ff\"}\n"));
  EXPECT_THAT(text, HasSubstr("\"bytes\":\"01\"}\n"));
  const std::string documents = cat({}, {false, {}});
  EXPECT_THAT(documents, HasSubstr("# it was recorded without a schema\nbytes: \"01ff\"\n"));
  EXPECT_THAT(documents, HasSubstr("# its schema is in 'ros2idl'"));
}

TEST_F(Cat, PrintsYamlDocuments) {
  EXPECT_EQ(cat({{"meadow"}, {}, "", {}}, {false, {}}),
            "---\n"
            "topic: meadow\n"
            "sequence: 1\n"
            "log_time_ns: 2000000000\n"
            "publish_time_ns: 7\n"
            "value:\n"
            "  area_m2: 2.5\n"
            "  flowers: [7]\n"
            "  kind: CLOVER\n");
  EXPECT_THAT(cat({{"meadow"}, {}, "", {"flowers", "kind"}}, {false, {}}),
              HasSubstr("value:\n  flowers: [7]\n  kind: \"CLOVER\"\n"));
}

TEST_F(Cat, PrintsFieldsOfThoseTopicsThatHaveThem) {
  const std::string text = cat({{}, {}, "", {"header.tick", "inputs[1]"}}, {true, {}});
  EXPECT_THAT(text, HasSubstr("\"value\":{\"header.tick\": 0, \"inputs[1]\": 0}}\n"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
}

TEST_F(Cat, TakesTrialsFiltersAndSoManyMessages) {
  EXPECT_THAT(cat({{}, 2, "", {}}, {true, {}}), testing::Not(HasSubstr("\"tick\": 0")));
  const std::string filtered = cat({{}, {}, "header.tick = 1", {"header.tick"}}, {true, {}});
  EXPECT_EQ(std::count(filtered.begin(), filtered.end(), '\n'), 1);
  const std::string two = cat({}, {true, 2U});
  EXPECT_EQ(std::count(two.begin(), two.end(), '\n'), 2);
  EXPECT_EQ(cat({}, {true, 0U}), "");
}

TEST_F(Cat, SaysWhyNoTopicFits) {
  try {
    cat({{}, {}, "height > 3", {}}, {true, {}});
    FAIL() << "no refusal";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("meadow: "));
    EXPECT_THAT(error.what(), HasSubstr("noise: it was recorded without a schema"));
  }
}

TEST(BrokenSample, IsNamed) {
  const TemporaryFolder folder;
  {
    LogWriter log(folder / "x.mcap");
    const auto meadow = log.add_channel("meadow", "meadow::Patch", "omgidl", kMeadowIdl);
    log.write(meadow, 7, patch(2.5, {7}));
    log.write(meadow, 8, std::string_view("\0\1\0\0too short", 13));
    log.close();
  }
  const Log log(folder / "x.mcap");
  std::ostringstream out;
  try {
    print_messages(log, Selection(log, {}), {true, {}}, out);
    FAIL() << "no error";
  } catch (const bus::Error& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("meadow, message 1: meadow::Patch: "));
  }
}

}  // namespace
}  // namespace scarab::log::test
