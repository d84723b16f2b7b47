#include "common/runtime/guarded_body.hpp"

namespace scarab::runtime {

void GuardedBody::begin_trial(std::uint32_t trial) {
  try {
    if (!gate_.in_safe_stop()) body_.activate();
    gate_.begin_trial(trial, body_.held_rad(), body_.home_rad());
  } catch (...) {
    body_.rest();
    throw;
  }
  in_trial_ = active_ = true;
}

void GuardedBody::end_trial() noexcept {
  gate_.end_trial();
  rest();
}

void GuardedBody::rest() noexcept {
  in_trial_ = active_ = false;
  body_.rest();
}

void GuardedBody::expect(std::uint32_t tick) {
  gate_.expect(tick);
  follow_gate();
}

void GuardedBody::emergency_stop(const std::string& reason) {
  gate_.emergency_stop(reason);
  follow_gate();
}

void GuardedBody::end(const TrialEnd& end) {
  body_.safe_stop();
  body_.end(end);
}

std::optional<std::string> GuardedBody::reset() {
  if (!gate_.in_safe_stop()) return std::nullopt;
  if (auto lasting = fault()) return lasting;
  try {
    if (in_trial_) body_.activate();
    gate_.reset(in_trial_ ? body_.held_rad() : gate_.target_rad());
  } catch (const std::exception& error) {
    body_.safe_stop();
    return error.what();
  }
  active_ = in_trial_;
  stop_told_ = false;
  return std::nullopt;
}

bool GuardedBody::observe(scarab_RobotState& state) {
  try {
    body_.observe(state);
    thrown_.reset();
  } catch (const std::exception& error) {
    state = {};
    take_thrown(error);
  }
  watch_for_fault();
  return !thrown_;
}

void GuardedBody::advance(const robot::JointVector& target_rad,
                          const std::function<void()>& sample) {
  try {
    body_.advance(target_rad, sample);
  } catch (const std::exception& error) {
    take_thrown(error);
    watch_for_fault();
  }
}

bool GuardedBody::idle() {
  try {
    const bool tells = body_.idle();
    thrown_.reset();
    return tells;
  } catch (const std::exception& error) {
    thrown_ = error.what();
    return false;
  }
}

std::optional<std::string> GuardedBody::fault() const { return thrown_ ? thrown_ : body_.fault(); }

void GuardedBody::take_thrown(const std::exception& error) {
  if (in_trial_ && on_throw_ == OnThrow::kPassOn) throw BodyFailure(error.what());
  thrown_ = error.what();
}

/// Between trials nothing can move that would have to be stopped: no trial starts while it lasts.
void GuardedBody::watch_for_fault() {
  if (!in_trial_) return;
  const auto reason = fault();
  if (!reason) return;
  active_ = false;
  gate_.safe_stop(*reason);
  follow_gate();
}

void GuardedBody::follow_gate() noexcept {
  if (!gate_.in_safe_stop() || stop_told_) return;
  stop_told_ = true;
  body_.safe_stop();
}

}  // namespace scarab::runtime
