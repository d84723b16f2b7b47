#include "common/safety/command_gate.hpp"

#include <cmath>
#include <utility>

namespace scarab::safety {
namespace {

Verdict refused(Outcome outcome, std::string fault = {}) {
  return {outcome, false, std::move(fault)};
}

std::string joint_name(std::size_t slot) { return std::string(robot::kJointNames[slot]); }

}  // namespace

CommandGate::CommandGate(const robot::RobotModel& robot, const GateOptions& options)
    : robot_(robot),
      options_(options),
      limiter_(robot, options.tick_period_s, options.homing_velocity_rad_s) {}

void CommandGate::begin_trial(std::uint32_t trial, const robot::JointVector& held_rad,
                              const robot::JointVector& home_rad) {
  end_trial();
  limiter_.start_from(held_rad);
  home_rad_ = limiter_.reachable(home_rad);
  // Who was put at a home beyond its range by hand stays there until the first command.
  homing_ = held_rad != home_rad && limiter_.target_rad() != home_rad_;
  trial_ = trial;
  expected_.reset();
  answered_ = false;
  stale_ticks_ = 0;
  measured_rad_.reset();
  answers_.fill(std::nullopt);
}

void CommandGate::end_trial() noexcept {
  trial_.reset();
  expected_.reset();
}

void CommandGate::expect(std::uint32_t tick) {
  stale_ticks_ = expected_ && !answered_ ? stale_ticks_ + 1 : 0;
  const bool too_many =
      options_.stale_ticks_limit > 0 && stale_ticks_ >= options_.stale_ticks_limit;
  if (too_many) safe_stop("no valid joint_command for " + std::to_string(stale_ticks_) + " ticks");
  expected_ = tick;
  answered_ = false;
  advance_homing();
}

void CommandGate::advance_homing() {
  if (!homing_ || safe_stop_) return;
  homing_ = limiter_.target_rad() != home_rad_;
  if (homing_) limiter_.advance_home(home_rad_);
}

Verdict CommandGate::offer(const Offer& offer) {
  Verdict verdict = judge(offer);
  ++counters_.outcomes[static_cast<std::size_t>(verdict.outcome)];
  answered_ = answered_ || verdict.answers;
  return verdict;
}

Verdict CommandGate::judge(const Offer& offer) {
  if (!trial_) return refused(Outcome::kInactive);
  if (offer.trial != *trial_) return refused(Outcome::kWrongTrial);
  if (!expected_ || offer.tick > *expected_) return refused(Outcome::kFutureTick);
  if (const auto slot = not_finite(offer)) {
    return refused(Outcome::kNotFinite, "joint_command " + std::to_string(offer.tick) + ": " +
                                            joint_name(*slot) + " is not finite");
  }
  if (const Offer* known = remembered(offer.tick)) return compare(*known, offer);
  if (offer.tick < *expected_) return refused(Outcome::kStaleTick);
  return accept(offer);
}

Verdict CommandGate::accept(const Offer& offer) {
  answers_[offer.tick % answers_.size()] = offer;
  if (safe_stop_) return {Outcome::kSafeStop, true, {}};
  if (homing_) return {Outcome::kHoming, true, {}};
  if (!offer.stop) limiter_.advance(offer.position_rad, measured_rad_, counters_);
  return {Outcome::kAccepted, true, {}};
}

Verdict CommandGate::compare(const Offer& known, const Offer& offer) const {
  const std::string of_tick = "two different joint_command " + std::to_string(offer.tick) + ": ";
  if (known.stop != offer.stop) {
    return refused(Outcome::kConflict, of_tick + "one says stop, the other does not");
  }
  for (std::size_t slot = 0; slot < robot::kJointCount && !offer.stop; ++slot) {
    if (!robot_.joints[slot].present || known.position_rad[slot] == offer.position_rad[slot])
      continue;
    return refused(Outcome::kConflict, of_tick + joint_name(slot) + " is " +
                                           std::to_string(known.position_rad[slot]) + " and " +
                                           std::to_string(offer.position_rad[slot]) + " rad");
  }
  return {Outcome::kDuplicate, offer.tick == *expected_, {}};
}

std::optional<std::size_t> CommandGate::not_finite(const Offer& offer) const {
  for (std::size_t slot = 0; slot < robot::kJointCount && !offer.stop; ++slot) {
    if (robot_.joints[slot].present && !std::isfinite(offer.position_rad[slot])) return slot;
  }
  return std::nullopt;
}

const Offer* CommandGate::remembered(std::uint32_t tick) const {
  const auto& answer = answers_[tick % answers_.size()];
  return answer && answer->tick == tick ? &*answer : nullptr;
}

void CommandGate::emergency_stop(std::string reason) noexcept {
  if (emergency_) return;  // the first one is the one to know
  emergency_ = true;
  hold(std::move(reason));
}

void CommandGate::safe_stop(std::string reason) noexcept {
  if (!safe_stop_) hold(std::move(reason));
}

void CommandGate::hold(std::string reason) noexcept {
  counters_.safe_stops += safe_stop_ ? 0 : 1;
  safe_stop_ = true;
  safe_stop_reason_ = std::move(reason);
}

void CommandGate::reset(const robot::JointVector& held_rad) {
  if (!safe_stop_) return;
  limiter_.start_from(held_rad);
  safe_stop_ = emergency_ = false;
  safe_stop_reason_.clear();
  stale_ticks_ = 0;
  homing_ = true;
}

}  // namespace scarab::safety
