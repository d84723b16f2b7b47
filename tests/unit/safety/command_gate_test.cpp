#include "common/safety/command_gate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include "tests/unit/safety/small_robot.hpp"

namespace scarab::safety {
namespace {

using testing::HasSubstr;

/// Refused for `outcome`: nothing moves, the tick stays without an answer, and it is counted.
void expect_refused(CommandGate& gate, const Offer& offer, Outcome outcome) {
  const robot::JointVector before = gate.target_rad();
  const std::uint64_t count = gate.counters().of(outcome);
  const Verdict verdict = gate.offer(offer);
  EXPECT_EQ(verdict.outcome, outcome);
  EXPECT_FALSE(verdict.answers);
  EXPECT_EQ(gate.target_rad(), before);
  EXPECT_EQ(gate.counters().of(outcome), count + 1);
}

TEST(CommandGate, AppliesTheAnswerToTheExpectedTick) {
  CommandGate gate = ready_gate();
  const Verdict verdict = gate.offer(position(0, 0.1));
  EXPECT_EQ(verdict.outcome, Outcome::kAccepted);
  EXPECT_TRUE(verdict.answers);
  EXPECT_TRUE(verdict.fault.empty());
  EXPECT_EQ(gate.target_rad()[0], 0.1);
  EXPECT_EQ(gate.target_rad()[robot::kBackboneSlot], 0.0) << "absent";
}

TEST(CommandGate, HoldsItsTargetsOnStop) {
  CommandGate gate = ready_gate();
  gate.offer(position(0, 0.1));
  gate.expect(1);
  const Verdict verdict = gate.offer(stop(1));
  EXPECT_EQ(verdict.outcome, Outcome::kAccepted);
  EXPECT_TRUE(verdict.answers);
  EXPECT_EQ(gate.target_rad()[0], 0.1);
  EXPECT_FALSE(gate.in_safe_stop());
}

TEST(CommandGate, RefusesWhenNoTrialRuns) {
  CommandGate gate(small_robot(), kTickPeriod);
  expect_refused(gate, position(0, 0.1), Outcome::kInactive);
  gate.begin_trial(1, all(0), all(0));
  gate.expect(0);
  gate.end_trial();
  expect_refused(gate, position(0, 0.1), Outcome::kInactive);
}

TEST(CommandGate, RefusesAnotherTrial) {
  CommandGate gate = ready_gate();
  expect_refused(gate, position(0, 0.1, 2), Outcome::kWrongTrial);
  gate.begin_trial(2, all(0), all(0));
  gate.expect(0);
  expect_refused(gate, position(0, 0.1, 1), Outcome::kWrongTrial);
}

TEST(CommandGate, RefusesTicksThatAreOverOrNotYetAsked) {
  CommandGate gate = ready_gate();
  expect_refused(gate, position(1, 0.1), Outcome::kFutureTick);
  gate.expect(1);
  expect_refused(gate, position(0, 0.1), Outcome::kStaleTick);
  gate.begin_trial(2, all(0), all(0));
  expect_refused(gate, position(0, 0.1, 2), Outcome::kFutureTick);
}

TEST(CommandGate, RefusesWhatIsNotFiniteAndNamesTheJoint) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()}) {
    CommandGate gate = ready_gate();
    Offer offer = position(0, 0.1);
    offer.position_rad[7] = bad;
    expect_refused(gate, offer, Outcome::kNotFinite);
    EXPECT_EQ(gate.offer(offer).fault, "joint_command 0: CL1 is not finite");
    EXPECT_EQ(gate.offer(position(0, 0.1)).outcome, Outcome::kAccepted) << "a replica may answer";
  }
}

TEST(CommandGate, IgnoresTheSlotsOfAbsentJoints) {
  CommandGate gate = ready_gate();
  Offer offer = position(0, 0.1);
  offer.position_rad[robot::kBackboneSlot] = std::nan("");
  EXPECT_EQ(gate.offer(offer).outcome, Outcome::kAccepted);
  EXPECT_EQ(gate.offer(offer).outcome, Outcome::kDuplicate);
  EXPECT_EQ(gate.target_rad()[robot::kBackboneSlot], 0.0);
}

TEST(CommandGate, TakesTheSameAnswerAgainWithoutApplyingItTwice) {
  CommandGate gate = ready_gate();
  gate.offer(position(0, 0.5));  // two windows and a half away
  const robot::JointVector after_first = gate.target_rad();
  const Verdict again = gate.offer(position(0, 0.5));
  EXPECT_EQ(again.outcome, Outcome::kDuplicate);
  EXPECT_TRUE(again.answers);
  EXPECT_EQ(gate.target_rad(), after_first);
}

TEST(CommandGate, RefusesASecondDifferentAnswerAsAFault) {
  CommandGate gate = ready_gate();
  gate.offer(position(0, 0.1));
  expect_refused(gate, position(0, 0.11), Outcome::kConflict);
  expect_refused(gate, stop(0), Outcome::kConflict);
  EXPECT_THAT(gate.offer(position(0, 0.11)).fault,
              HasSubstr("two different joint_command 0: TL0 is 0.1"));
}

TEST(CommandGate, ComparesALateReplicaWithTheAnswerThatWasTaken) {
  CommandGate gate = ready_gate();
  gate.offer(position(0, 0.1));
  gate.expect(1);
  const Verdict late = gate.offer(position(0, 0.1));
  EXPECT_EQ(late.outcome, Outcome::kDuplicate);
  EXPECT_FALSE(late.answers) << "tick 1 still waits";
  expect_refused(gate, position(0, 0.2), Outcome::kConflict);
}

TEST(CommandGate, ForgetsAnswersOfATrialWhenTheNextBegins) {
  CommandGate gate = ready_gate();
  gate.offer(position(0, 0.1));
  gate.begin_trial(2, all(0), all(0));
  gate.expect(0);
  EXPECT_EQ(gate.offer(position(0, 0.05, 2)).outcome, Outcome::kAccepted);
}

TEST(CommandGate, CountsUnderDistinctNamesThatFitServiceStatus) {
  CommandGate gate = ready_gate();
  gate.offer(position(0, 0.1));
  const auto named = gate.counters().named();
  EXPECT_LE(named.size(), 32U);
  EXPECT_THAT(named, testing::Contains(testing::Pair("commands_accepted", 1U)));
  std::set<std::string> names;
  for (const auto& entry : named) {
    EXPECT_LE(entry.first.size(), 47U);
    names.insert(entry.first);
  }
  EXPECT_EQ(names.size(), named.size());
}

TEST(CommandGate, RefusesNonsenseFromItsOwner) {
  EXPECT_THROW(CommandGate(small_robot(), 0.0), std::invalid_argument);
  CommandGate gate(small_robot(), kTickPeriod);
  EXPECT_THROW(gate.begin_trial(1, all(std::nan("")), all(0)), std::invalid_argument);
  EXPECT_THROW(gate.begin_trial(1, all(0), all(std::nan(""))), std::invalid_argument);
  expect_refused(gate, position(0, 0.1), Outcome::kInactive);
}

}  // namespace
}  // namespace scarab::safety
