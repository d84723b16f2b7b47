#include "common/config/extends.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "common/config/config.hpp"
#include "common/config/robot_file.hpp"
#include "tests/unit/config/gait.hpp"

namespace scarab::config {
namespace {

using gait::Gait;
using gait::kGood;

/// A folder of its own for each case.
class Extends : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) / ("extends_" + std::string(info->name()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    const std::filesystem::path file = folder_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file.string();
  }

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }

  /// What is wrong with a file, or nothing.
  [[nodiscard]] std::string error_of(const std::string& name) const {
    try {
      (void)load<Gait>(path(name));
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

 private:
  std::filesystem::path folder_;
};

TEST_F(Extends, TakesWhatIsNotGivenFromTheBase) {
  write("base.yaml", kGood);
  const auto base = load<Gait>(path("base.yaml"));
  const auto same = load<Gait>(write("same.yaml", "extends: base.yaml\n"));
  EXPECT_EQ(dump(same), dump(base));
  const auto faster = load<Gait>(write("faster.yaml", "extends: base.yaml\nfrequency_hz: 3\n"));
  EXPECT_EQ(faster.frequency_hz, 3);
  EXPECT_EQ(faster.name, base.name);
}

TEST_F(Extends, MergesMapsAtEveryDepthAndReplacesLists) {
  write("base.yaml", kGood);
  const auto gait = load<Gait>(write("x.yaml",
                                     "extends: base.yaml\n"
                                     "legs: 1\n"
                                     "order: [7]\n"
                                     "parts:\n  right: {length_m: 0.9}\n"
                                     "  extra: {length_m: 0.2, present: true}\n"));
  EXPECT_EQ(gait.order, std::vector<int>{7});
  ASSERT_EQ(gait.parts.size(), 3U);
  EXPECT_EQ(gait.parts.at("right").length_m, 0.9);
  EXPECT_FALSE(gait.parts.at("right").present);
  EXPECT_EQ(gait.parts.at("left").length_m, 0.3);
}

TEST_F(Extends, LetsAMapAndTheWordAbsentReplaceEachOther) {
  write("base.yaml", kGood);
  write("tailed.yaml", "extends: base.yaml\ntail: {length_m: 0.1, present: true}\n");
  write("tailless.yaml", "extends: tailed.yaml\ntail: absent\n");
  EXPECT_TRUE(load<Gait>(path("tailed.yaml")).tail.has_value());
  EXPECT_FALSE(load<Gait>(path("tailless.yaml")).tail.has_value());
}

TEST_F(Extends, FollowsAChainThroughFoldersEachRelativeToItsOwnFile) {
  write("one/base.yaml", kGood);
  write("two/middle.yaml", "extends: ../one/base.yaml\nname: middle\noffset: 5\n");
  const auto gait = load<Gait>(write("top.yaml", "extends: two/middle.yaml\nname: top\n"));
  EXPECT_EQ(gait.name, "top");
  EXPECT_EQ(gait.offset, 5);
  EXPECT_EQ(gait.frequency_hz, 1.5);
}

TEST_F(Extends, DumpsTheWholeSoThatItNeedsNoBase) {
  write("base.yaml", kGood);
  const std::string dumped = dump(load<Gait>(write("x.yaml", "extends: base.yaml\nname: x\n")));
  EXPECT_EQ(dumped.find("extends"), std::string::npos);
  EXPECT_EQ(dump(load_text<Gait>("dump", dumped)), dumped);
}

TEST_F(Extends, NamesTheFileInWhichABadValueStands) {
  const std::string good = kGood;
  write("base.yaml", "frequency_hz: 99\n" + good.substr(0, good.find("frequency")) +
                         good.substr(good.find("offset")));
  write("x.yaml", "extends: base.yaml\nname: x\n");
  EXPECT_EQ(error_of("x.yaml"), path("base.yaml") +
                                    ":1:15: frequency_hz: 99 is not in [0.1, 5] (extended by '" +
                                    path("x.yaml") + "')");
  write("x.yaml", "extends: base.yaml\n\nfrequency_hz: 98\n");
  EXPECT_EQ(error_of("x.yaml"), path("x.yaml") + ":3:15: frequency_hz: 98 is not in [0.1, 5]");
}

TEST_F(Extends, NamesTheFileInWhichAnUnknownKeyStands) {
  write("base.yaml", std::string(kGood) + "frequenzy_hz: 1\n");
  write("x.yaml", "extends: base.yaml\n");
  EXPECT_EQ(error_of("x.yaml"), path("base.yaml") +
                                    ":18:1: frequenzy_hz: unknown key; did you mean "
                                    "'frequency_hz'? (extended by '" +
                                    path("x.yaml") + "')");
  write("base.yaml", kGood);
  write("x.yaml", "extends: base.yaml\nparts:\n  left:\n    lenght_m: 1\n");
  EXPECT_EQ(error_of("x.yaml"), path("x.yaml") +
                                    ":4:5: parts.left.lenght_m: unknown key; did you mean "
                                    "'length_m'?");
}

TEST_F(Extends, NamesTheFileOfAKeyThatBreaksAConditionBetweenTwoFiles) {
  write("base.yaml", kGood);
  write("x.yaml", "extends: base.yaml\nlegs: 3\n");
  EXPECT_EQ(error_of("x.yaml"), path("base.yaml") +
                                    ":9:8: order: needs one entry for each leg (extended by '" +
                                    path("x.yaml") + "')");
}

TEST_F(Extends, MissesAKeyThatNoFileOfTheChainGives) {
  write("base.yaml", "name: walk\n");
  write("x.yaml", "extends: base.yaml\nkind: wave\n");
  EXPECT_EQ(error_of("x.yaml"), path("x.yaml") + ":1:1: frequency_hz: missing key");
}

TEST_F(Extends, RefusesAMissingBase) {
  write("x.yaml", "# why\nextends: nobody.yaml\n");
  const std::string error = error_of("x.yaml");
  EXPECT_EQ(error.rfind(path("x.yaml") + ":2:10: extends: no file '", 0), 0U) << error;
}

TEST_F(Extends, RefusesWhatIsNotTheNameOfAFile) {
  write("x.yaml", "extends: [a.yaml, b.yaml]\n");
  EXPECT_EQ(error_of("x.yaml"), path("x.yaml") + ":1:10: extends: expected text, found a list");
  write("x.yaml", "extends:\n");
  EXPECT_EQ(error_of("x.yaml"), path("x.yaml") + ":1:1: extends: expected text, found nothing");
  write("x.yaml", "extends: ''\n");
  EXPECT_NE(error_of("x.yaml").find(":1:10: extends: no file "), std::string::npos);
}

TEST_F(Extends, RefusesABaseThatIsNoMap) {
  write("base.yaml", "- 1\n");
  write("x.yaml", "extends: base.yaml\n");
  EXPECT_EQ(error_of("x.yaml").rfind(path("base.yaml") + ":1:1: (top level): expected a map", 0),
            0U);
}

TEST_F(Extends, RefusesACircle) {
  write("self.yaml", "extends: self.yaml\n");
  EXPECT_NE(error_of("self.yaml").find("self.yaml:1:10: extends: a circle: "), std::string::npos);
  write("a.yaml", "extends: b.yaml\n");
  write("b.yaml", "extends: ./c/../c.yaml\n");
  write("c.yaml", "extends: b.yaml\n");
  EXPECT_EQ(error_of("a.yaml").rfind(path("c.yaml") + ":1:10: extends: a circle: ", 0), 0U)
      << error_of("a.yaml");
}

TEST_F(Extends, AllowsEightBasesAndRefusesNine) {
  write("0.yaml", kGood);
  for (int level = 1; level <= 9; ++level) {
    write(std::to_string(level) + ".yaml", "extends: " + std::to_string(level - 1) + ".yaml\n");
  }
  EXPECT_EQ(error_of("8.yaml"), "");
  EXPECT_EQ(error_of("9.yaml"),
            path("1.yaml") + ":1:10: extends: more than 8 files extend each other");
}

TEST_F(Extends, IsTheFirstKeyAndAnUnknownOneElsewhere) {
  write("base.yaml", kGood);
  write("x.yaml", "name: x\nextends: base.yaml\n");
  EXPECT_EQ(error_of("x.yaml"),
            path("x.yaml") + ":2:10: extends: must be the first key of the file");
  write("x.yaml", "extends: base.yaml\ntail:\n  extends: base.yaml\n");
  EXPECT_EQ(error_of("x.yaml").rfind(path("x.yaml") + ":3:3: tail.extends: unknown key", 0), 0U);
}

TEST_F(Extends, ServesRobotFilesToo) {
  const std::string beetle = SCARAB_SOURCE_DIR "/config/robot/beetle.yaml";
  const auto robot = load_robot(write("stiff.yaml", "extends: " + beetle +
                                                        "\nname: stiff\nservos:\n  leg:\n    "
                                                        "kp_nm_rad: 25\nbackbone: absent\n"));
  const auto original = load_robot(beetle);
  EXPECT_EQ(robot.name, "stiff");
  EXPECT_EQ(robot.joints[0].kp_nm_rad, 25);
  EXPECT_EQ(robot.joints[0].torque_max_nm, original.joints[0].torque_max_nm);
  EXPECT_TRUE(original.joints[robot::kBackboneSlot].present);
  EXPECT_FALSE(robot.joints[robot::kBackboneSlot].present);
}

}  // namespace
}  // namespace scarab::config
