#include "tools/emulator/faults/fault_text.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

#include "common/robot/joints.hpp"

namespace scarab::emulator {
namespace {

using testing::HasSubstr;

Fault fault(std::string_view text) { return std::get<Fault>(parse_fault_order(text)); }

std::string refusal(std::string_view text) {
  try {
    (void)parse_fault_order(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(FaultText, EveryWordIsReadAndWrittenTheSame) {
  for (const char* text :
       {"lose 0.01", "flip 1", "stuck TR0", "silent BJ", "silent imu", "silent board", "late 0.5",
        "unplug", "hot FL2 95.5", "current CR1 3", "tilt -0.4", "pose TL0 -0.3"}) {
    for (const char* when : {"", " at 3", " for 0.25", " at 1.5 for 2"}) {
      const std::string line = std::string(text) + when;
      EXPECT_EQ(to_text(fault(line)), line);
    }
  }
}

TEST(FaultText, SaysWhatItMeans) {
  const Fault stuck = fault("  stuck\tTR0   at 3 for 2\r");
  EXPECT_EQ(stuck.kind, FaultKind::kStuck);
  EXPECT_EQ(robot::kJointNames.at(stuck.joint), "TR0");
  EXPECT_EQ(stuck.at_s, 3);
  EXPECT_EQ(stuck.for_s, 2);
  EXPECT_EQ(fault("tilt -0.4").value, -0.4);
  EXPECT_FALSE(fault("tilt -0.4").at_s);
  EXPECT_EQ(fault("silent imu").part, SilentPart::kImu);
  EXPECT_TRUE(std::holds_alternative<Clear>(parse_fault_order("clear")));
}

TEST(FaultText, SaysWhatIsWrong) {
  EXPECT_THAT(refusal(""), HasSubstr("empty"));
  EXPECT_THAT(refusal("explode"), HasSubstr("no fault 'explode'; there are lose, flip, stuck"));
  EXPECT_THAT(refusal("lose"), HasSubstr("lose needs a number"));
  EXPECT_THAT(refusal("lose much"), HasSubstr("lose: 'much' is no number"));
  EXPECT_THAT(refusal("lose nan"), HasSubstr("no number"));
  EXPECT_THAT(refusal("lose 0.1x"), HasSubstr("no number"));
  EXPECT_THAT(refusal("lose 1.5"), HasSubstr("1.5 is not between 0 and 1"));
  EXPECT_THAT(refusal("late -1"), HasSubstr("not between"));
  EXPECT_THAT(refusal("stuck"), HasSubstr("stuck needs a joint"));
  EXPECT_THAT(refusal("stuck tr0"), HasSubstr("there is no joint 'tr0'"));
  EXPECT_THAT(refusal("silent"), HasSubstr("imu or board"));
  EXPECT_THAT(refusal("hot TR0"), HasSubstr("hot needs a number"));
  EXPECT_THAT(refusal("unplug now"), HasSubstr("unplug: 'now' does not belong there"));
  EXPECT_THAT(refusal("unplug for"), HasSubstr("unplug for needs a number"));
  EXPECT_THAT(refusal("unplug for 1 at 2"), HasSubstr("'at' does not belong there"));
  EXPECT_THAT(refusal("clear lose"), HasSubstr("clear: 'lose' does not belong there"));
}

TEST(FaultText, HelpNamesEveryWord) {
  const std::string help = fault_words_help();
  for (const char* word : {"lose", "flip", "stuck", "silent", "late", "unplug", "hot", "current",
                           "tilt", "pose", "clear"}) {
    EXPECT_THAT(help, HasSubstr(std::string("  ") + word));
  }
}

}  // namespace
}  // namespace scarab::emulator
