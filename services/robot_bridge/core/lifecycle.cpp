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
  if (state_ != LifecycleState::kUnconfigured) refuse("configure");
  driver_.open();
  has_torque_switch_ = driver_.capabilities().torque_switch;
  state_ = LifecycleState::kInactive;
}

void Lifecycle::activate(const robot::JointVector& hold_rad) {
  if (!open()) refuse("activate");
  // Active from the first byte on: some motors may be on when a later one fails.
  state_ = LifecycleState::kActive;
  try {
    driver_.activate(hold_rad);
  } catch (...) {
    if (!deactivate()) give_up();
    throw;
  }
}

Readings Lifecycle::read() {
  if (!open()) refuse("read");
  try {
    return driver_.read();
  } catch (...) {
    fail();
    throw;
  }
}

void Lifecycle::write(const robot::JointVector& target_rad) {
  if (state_ != LifecycleState::kActive) refuse("write");
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
  const bool released = driver_.release();
  return !has_torque_switch_ || confirmed(released);
}

void Lifecycle::finalise() noexcept {
  if (state_ == LifecycleState::kFinalised) return;
  deactivate();
  if (open()) driver_.close();
  state_ = LifecycleState::kFinalised;
}

bool Lifecycle::open() const noexcept {
  return state_ == LifecycleState::kInactive || state_ == LifecycleState::kActive;
}

void Lifecycle::refuse(std::string_view call) const {
  throw std::logic_error("the device is " + std::string(name_of(state_)) + ": no " +
                         std::string(call));
}

bool Lifecycle::confirmed(bool by_device) noexcept {
  unconfirmed_stops_ += by_device ? 0 : 1;
  return by_device;
}

void Lifecycle::give_up() noexcept {
  if (!open()) return;
  ++failures_;
  driver_.close();
  state_ = LifecycleState::kUnconfigured;
}

/// What can still be stopped is stopped before the device is given up.
void Lifecycle::fail() noexcept {
  if (safe_stop_ == SafeStop::kHold) {
    hold();
  } else {
    deactivate();
  }
  give_up();
}

}  // namespace scarab::bridge
