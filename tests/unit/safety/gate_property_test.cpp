#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "common/random/random.hpp"
#include "common/safety/command_gate.hpp"
#include "tests/unit/safety/small_robot.hpp"

/// Streams of random commands and events: whatever arrives, what leaves the gate is safe.
namespace scarab::safety {
namespace {

constexpr std::uint64_t kTicks = 500;

/// Random numbers of one seed, by a running index.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : seed_(seed) {}
  double uniform(double min, double max) {
    return min + (max - min) * random::uniform(seed_, random::stream("gate"), index_++);
  }
  bool chance(double probability) { return uniform(0, 1) < probability; }

 private:
  std::uint64_t seed_;
  std::uint64_t index_ = 0;
};

double wild_angle(Dice& dice) {
  if (dice.chance(0.001)) return std::numeric_limits<double>::quiet_NaN();
  if (dice.chance(0.001)) return std::numeric_limits<double>::infinity();
  if (dice.chance(0.05)) return dice.uniform(-1, 1) * std::numeric_limits<double>::max();
  return dice.uniform(-2, 2);
}

Offer wild_offer(Dice& dice, std::uint32_t tick) {
  Offer offer;
  offer.trial = dice.chance(0.05) ? 2 : 1;
  offer.tick = dice.chance(0.1) ? static_cast<std::uint32_t>(dice.uniform(0, kTicks)) : tick;
  offer.stop = dice.chance(0.05);
  for (double& angle : offer.position_rad) angle = wild_angle(dice);
  return offer;
}

void expect_safe(const robot::RobotModel& robot, const robot::JointVector& before,
                 const robot::JointVector& after, bool moved_allowed) {
  for (std::size_t slot = 0; slot < robot::kJointCount; ++slot) {
    const robot::Joint& joint = robot.joints[slot];
    ASSERT_TRUE(std::isfinite(after[slot]));
    if (!joint.present || !moved_allowed) {
      ASSERT_EQ(after[slot], before[slot]);
      continue;
    }
    ASSERT_GE(after[slot], joint.min_rad);
    ASSERT_LE(after[slot], joint.max_rad);
    ASSERT_LE(std::abs(after[slot] - before[slot]), kWindow + 1e-12);
  }
}

class GateProperty : public testing::TestWithParam<std::uint64_t> {};

TEST_P(GateProperty, TargetsStayFiniteInRangeAndInTheWindow) {
  Dice dice(GetParam());
  const robot::RobotModel robot = small_robot();
  CommandGate gate = ready_gate(GetParam() % 2 == 0 ? 3 : 0);
  for (std::uint32_t tick = 0; tick < kTicks; ++tick) {
    gate.expect(tick);
    if (dice.chance(0.02)) gate.emergency_stop("dice");
    if (dice.chance(0.1)) gate.reset(gate.target_rad());
    if (dice.chance(0.1)) gate.observe(all(dice.uniform(-1, 0.5)));
    const robot::JointVector before = gate.target_rad();
    bool accepted = false;
    while (dice.chance(0.7)) {
      const Verdict verdict = gate.offer(wild_offer(dice, tick));
      accepted = accepted || verdict.outcome == Outcome::kAccepted;
      expect_safe(robot, before, gate.target_rad(), accepted);
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GT(gate.counters().of(Outcome::kAccepted), 50U) << "the stream has to reach the servos";
  EXPECT_GT(gate.counters().of(Outcome::kConflict), 50U);
  EXPECT_GT(gate.counters().of(Clamp::kWindow), 50U);
}

INSTANTIATE_TEST_SUITE_P(Seeds, GateProperty, testing::Range<std::uint64_t>(0, 20));

TEST(GateProperty, EveryOfferIsCountedExactlyOnce) {
  Dice dice(99);
  CommandGate gate = ready_gate();
  std::uint64_t offers = 0;
  for (std::uint32_t tick = 0; tick < kTicks; ++tick) {
    gate.expect(tick);
    for (int i = 0; i < 3; ++i, ++offers) gate.offer(wild_offer(dice, tick));
  }
  std::uint64_t counted = 0;
  for (const std::uint64_t count : gate.counters().outcomes) counted += count;
  EXPECT_EQ(counted, offers);
}

TEST(GateProperty, EqualStreamsGiveEqualTargets) {
  CommandGate first = ready_gate(), second = ready_gate();
  Dice one(5), other(5);
  for (std::uint32_t tick = 0; tick < kTicks; ++tick) {
    first.expect(tick);
    second.expect(tick);
    first.offer(wild_offer(one, tick));
    second.offer(wild_offer(other, tick));
    ASSERT_EQ(first.target_rad(), second.target_rad());
  }
}

}  // namespace
}  // namespace scarab::safety
