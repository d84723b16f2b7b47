#include "services/robot_bridge/core/lifecycle.hpp"

#include <stdexcept>
#include <string>

namespace scarab::bridge {

std::string_view name_of(LifecycleState state) noexcept {
  switch (state) {
    case LifecycleState::kUnconfigured:
      return "unconfigured";
    case LifecycleState::kInactive:
      return "inactive";
    case LifecycleState::kActive:
      return "active";
    case LifecycleState::kFinalised:
      break;
  }
  return "finalised";
}

void Lifecycle::configure() {
  require(LifecycleState::kUnconfigured, "configure");
  driver_.open();
  state_ = LifecycleState::kInactive;
}

void Lifecycle::activate(const robot::JointVector& hold_rad) {
  require(LifecycleState::kInactive, "activate");
  // Active from the first byte on: some motors may be on when a later one fails.
  state_ = LifecycleState::kActive;
  try {
    driver_.activate(hold_rad);
  } catch (...) {
    if (!deactivate()) fail();
    throw;
  }
}

Readings Lifecycle::read() {
  if (state_ != LifecycleState::kActive) require(LifecycleState::kInactive, "read");
  try {
    return driver_.read();
  } catch (...) {
    fail();
    throw;
  }
}

void Lifecycle::write(const robot::JointVector& target_rad) {
  require(LifecycleState::kActive, "write");
  try {
    driver_.write(target_rad);
  } catch (...) {
    fail();
    throw;
  }
}

bool Lifecycle::hold() noexcept {
  return state_ != LifecycleState::kActive || confirmed(driver_.hold());
}

bool Lifecycle::deactivate() noexcept {
  if (state_ != LifecycleState::kActive) return true;
  state_ = LifecycleState::kInactive;
  return confirmed(driver_.release());
}

void Lifecycle::finalise() noexcept {
  if (state_ == LifecycleState::kFinalised) return;
  deactivate();
  if (state_ == LifecycleState::kInactive) driver_.close();
  state_ = LifecycleState::kFinalised;
}

void Lifecycle::require(LifecycleState state, std::string_view call) const {
  if (state_ == state) return;
  throw std::logic_error(std::string(call) + ": the device is " + std::string(name_of(state_)) +
                         ", not " + std::string(name_of(state)));
}

bool Lifecycle::confirmed(bool by_device) noexcept {
  unconfirmed_stops_ += by_device ? 0 : 1;
  return by_device;
}

/// The device is given up: what can still be stopped is stopped, then the line is closed, so that
/// the device's own time-out does the rest.
void Lifecycle::fail() noexcept {
  ++failures_;
  if (safe_stop_ == SafeStop::kHold) {
    hold();
  } else {
    deactivate();
  }
  driver_.close();
  state_ = LifecycleState::kUnconfigured;
}

}  // namespace scarab::bridge
