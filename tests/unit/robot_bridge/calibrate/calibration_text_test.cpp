#include "services/robot_bridge/calibrate/calibration_text.hpp"

#include <gmock/gmock.h>

#include "services/robot_bridge/calibration_file.hpp"

namespace scarab::bridge::calibrate {
namespace {

using testing::HasSubstr;
using testing::StrEq;

constexpr JointCalibration kEntry{0.1, -1, -1.5, 1.25};
const std::string kLine =
    "TL1: {offset_rad: 0.1000, direction: -1, min_rad: -1.5000, max_rad: 1.2500}  # today\n";

TEST(CalibrationText, ReplacesOneLineAndNothingElse) {
  const std::string before = "# of a robot\n\nTL0: absent   # why\n";
  const std::string after = "\n# more\nTL10: absent\n";
  EXPECT_THAT(with_entry(before + "TL1: {offset_rad: 0}  # old\n" + after, "TL1", kEntry, "today"),
              StrEq(before + kLine + after));
}

TEST(CalibrationText, ReplacesABlock) {
  EXPECT_THAT(with_entry("TL0: absent\nTL1:\n  offset_rad: 0\n  # inside\n  direction: 1\n\nTL2: "
                         "absent\n",
                         "TL1", kEntry, "today"),
              StrEq("TL0: absent\n" + kLine + "\nTL2: absent\n"));
}

TEST(CalibrationText, AddsWhatIsNotThere) {
  EXPECT_THAT(with_entry("TL0: absent", "TL1", kEntry, "today"), StrEq("TL0: absent\n" + kLine));
  EXPECT_THAT(with_entry("", "TL1", kEntry, "today"), StrEq(kLine));
}

TEST(CalibrationText, AnEmptyFileIsOneThatTheBridgeReads) {
  const Calibration empty = load_calibration_text("new.yaml", empty_calibration_text());
  for (const auto& joint : empty.joints) EXPECT_FALSE(joint.has_value());
  const Calibration one = load_calibration_text(
      "new.yaml", with_entry(empty_calibration_text(), "TL1", kEntry, "today"));
  ASSERT_TRUE(one.joints[1].has_value());
  EXPECT_EQ(one.joints[1]->offset_rad, 0.1);
  EXPECT_EQ(one.joints[1]->direction, -1);
}

}  // namespace
}  // namespace scarab::bridge::calibrate
