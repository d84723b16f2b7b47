#include <vector>

#include "tests/integration/robot_bridge/fixture.hpp"

namespace scarab::test {
namespace {

using Faults = BridgeProcess;

/// All causes one after the other in one trial: the robot stops, says why, cannot be reset while
/// the cause lasts, and goes on after it.
TEST_F(Faults, EachBringsTheSafeStopAndKeepsItFromBeingReset) {
  start_bridge(
      "loopback:\n"
      "  faults:\n"
      "    - {kind: hot, joint: CL1, value: 95, after_s: 1, for_s: 0.7}\n"
      "    - {kind: current, joint: FR2, value: 9, after_s: 3.5, for_s: 0.7}\n"
      "    - {kind: supply, value: 60, after_s: 6, for_s: 0.7}\n"
      "    - {kind: tilt, value: -1.3, after_s: 8.5, for_s: 0.7}\n"
      "    - {kind: error, joint: TL2, after_s: 11, for_s: 0.7}\n"
      "    - {kind: lost, after_s: 13.5, for_s: 0.7}\n");
  ASSERT_TRUE(begin());
  const std::vector<std::string> causes = {
      "CL1 has 95.00 C, more than 70 C",
      "FR2 draws 9.00 A, more than 3 A",
      "the robot draws 60.00 A, more than 25 A",
      "the trunk leans 1.30 rad, more than 0.9 rad",
      "TL2: as configured",
      "the device is lost: loopback: lost, as configured",
  };
  for (const std::string& cause : causes) {
    SCOPED_TRACE(cause);
    ASSERT_TRUE(answer_until(scarab_PHASE_SAFE_STOP)) << child_->err();
    ASSERT_TRUE(says("safe stop: " + cause)) << child_->err();
    EXPECT_TRUE(await([](const Report& r) { return r.lifecycle == scarab_LIFECYCLE_INACTIVE; }));
    tell(scarab_OPERATOR_RESET);
    EXPECT_TRUE(says("reset refused: " + cause));
    // The operator tries again until the cause is over.
    ASSERT_TRUE(answer_until([&](const auto& state) {
      if (state.phase == scarab_PHASE_SAFE_STOP) tell(scarab_OPERATOR_RESET);
      return state.phase == scarab_PHASE_RUNNING;
    })) << child_->err();
    EXPECT_TRUE(await([](const Report& r) { return r.lifecycle == scarab_LIFECYCLE_ACTIVE; }));
  }
  EXPECT_EQ(counter("device_losses"), 1U);
  EXPECT_EQ(counter("safe_stops"), causes.size());
}

/// A device that is lost says nothing: no number of it is passed on as measured.
TEST_F(Faults, ALostDeviceMeasuresNothingAndIsFoundAgain) {
  start_bridge("loopback: {faults: [{kind: lost, after_s: 1, for_s: 1}]}\n");
  ASSERT_TRUE(begin());
  const auto lost = answer_until(scarab_PHASE_SAFE_STOP);
  ASSERT_TRUE(lost) << child_->err();
  EXPECT_EQ(lost->position_source[0], scarab_SOURCE_ABSENT);
  EXPECT_EQ(lost->position_rad[14], 0) << "it stood in its start pose, but who knows now";
  EXPECT_EQ(lost->imu_source, scarab_SOURCE_ABSENT);
  EXPECT_EQ(lost->motion_source, scarab_SOURCE_ABSENT);
  EXPECT_EQ(lost->acceleration_m_s2[2], 0);
  const auto found = answer_until([](const auto& state) { return all_measured(state); });
  ASSERT_TRUE(found) << child_->err();
  EXPECT_EQ(found->phase, scarab_PHASE_SAFE_STOP) << "found again is no reason to move";
  EXPECT_EQ(child_->stop(), 0);
}

}  // namespace
}  // namespace scarab::test
