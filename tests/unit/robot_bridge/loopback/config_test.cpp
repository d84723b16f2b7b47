#include "services/robot_bridge/drivers/loopback/config.hpp"

#include <gmock/gmock.h>

#include "common/config/config.hpp"

namespace scarab::bridge::loopback {
namespace {

using testing::HasSubstr;

std::string refusal(const std::string& text) {
  try {
    (void)config::load_text<Config>("bridge.yaml", text);
  } catch (const config::Error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(LoopbackConfig, NeedsNothing) {
  const auto config = config::load_text<Config>("bridge.yaml", "{}");
  EXPECT_EQ(config.appears_after_s, 0);
  EXPECT_TRUE(config.faults.empty());
}

TEST(LoopbackConfig, ReadsBackWhatItDumps) {
  const std::string text =
      "{appears_after_s: 2, pose_rad: {TL0: 0.3}, mounting: {CR1: {offset_rad: 0.1, direction: "
      "-1}}, faults: [{kind: hot, joint: FL2, value: 90, after_s: 1, for_s: 2}, {kind: lost}]}";
  const auto config = config::load_text<Config>("bridge.yaml", text);
  ASSERT_EQ(config.faults.size(), 2U);
  EXPECT_EQ(config.faults[0].kind, FaultKind::kHot);
  EXPECT_EQ(config.faults[0].joint, "FL2");
  EXPECT_EQ(config.mounting.at("CR1").direction, -1);
  EXPECT_EQ(config::dump(config::load_text<Config>("again.yaml", config::dump(config))),
            config::dump(config));
}

TEST(LoopbackConfig, NamesWhatIsNotThere) {
  EXPECT_THAT(refusal("{pose_rad: {TL9: 0}}"), HasSubstr("no joint TL9"));
  EXPECT_THAT(refusal("{mounting: {XX: {offset_rad: 0, direction: 1}}}"), HasSubstr("no joint XX"));
  EXPECT_THAT(refusal("{mounting: {TL0: {offset_rad: 0, direction: 2}}}"), HasSubstr("1 or -1"));
  EXPECT_THAT(refusal("{faults: [{kind: hot, value: 90}]}"), HasSubstr("are of a joint"));
  EXPECT_THAT(refusal("{faults: [{kind: lost, joint: TL0}]}"), HasSubstr("are of a joint"));
  EXPECT_THAT(refusal("{faults: [{kind: melted}]}"), HasSubstr("melted"));
}

}  // namespace
}  // namespace scarab::bridge::loopback
