#include "services/robot_bridge/core/guarded_device.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

namespace scarab::bridge {

GuardedDevice::GuardedDevice(Driver& driver, SafeStop safe_stop, const LimitsConfig& limits,
                             const robot::JointVector& home_rad)
    : safe_stop_(safe_stop), lifecycle_(driver, safe_stop), limits_(limits), held_rad_(home_rad) {}

bool GuardedDevice::present() const noexcept {
  return state() == LifecycleState::kInactive || state() == LifecycleState::kActive;
}

void GuardedDevice::look_for(double now_s) {
  if (state() != LifecycleState::kUnconfigured || now_s < attempt_s_ + pause_s_) return;
  try {
    lifecycle_.configure();
    absence_.clear();
    pause_s_ = 0;
  } catch (const std::exception& error) {
    absence_ = error.what();
    attempt_s_ = now_s;
    pause_s_ = std::clamp(2 * pause_s_, kFirstPause_s, kLongestPause_s);
  }
}

void GuardedDevice::exchange() {
  if (!present()) return;
  try {
    readings_ = lifecycle_.read();
  } catch (const std::exception& error) {
    lose(error.what());
    return;
  }
  limits_.observe(readings_);
}

void GuardedDevice::activate() {
  const bool was_in_use = std::exchange(in_use_, true);
  try {
    exchange();
    if (const auto reason = fault()) throw DeviceError(*reason);
    const robot::JointVector hold_rad = standing_rad();
    lifecycle_.activate(hold_rad);
    held_rad_ = hold_rad;
    stopped_ = false;
  } catch (const std::exception& error) {
    if (state() == LifecycleState::kUnconfigured && absence_.empty()) lose(error.what());
    in_use_ = was_in_use;
    throw;
  }
}

/// Measured where it is; else where the joint was last told to go, also before a loss.
robot::JointVector GuardedDevice::standing_rad() const {
  robot::JointVector standing_rad = held_rad_;
  for (std::size_t slot = 0; slot < standing_rad.size(); ++slot) {
    const double position_rad = readings_.position_rad.value[slot];
    const bool measured = readings_.position_rad.source[slot] == Source::kMeasured;
    if (measured && std::isfinite(position_rad)) standing_rad[slot] = position_rad;
  }
  return standing_rad;
}

void GuardedDevice::apply(const robot::JointVector& target_rad) {
  if (stopped_ || state() != LifecycleState::kActive) return;
  try {
    lifecycle_.write(target_rad);
    held_rad_ = target_rad;
  } catch (const std::exception& error) {
    lose(error.what());
  }
}

void GuardedDevice::safe_stop() noexcept {
  stopped_ = true;
  const bool confirmed =
      safe_stop_ == SafeStop::kHold ? lifecycle_.hold() : lifecycle_.deactivate();
  if (confirmed) return;
  lifecycle_.give_up();
  lose("it did not confirm the safe stop");
}

void GuardedDevice::rest() noexcept {
  in_use_ = false;
  if (lifecycle_.deactivate()) return;
  lifecycle_.give_up();
  lose("it did not confirm that its motors are off");
}

/// After the lifecycle has closed the device.
void GuardedDevice::lose(const std::string& why) noexcept {
  absence_ = loss_ = why;
  readings_ = {};
  limits_.forget();
  pause_s_ = 0;  // the first attempt to find it again comes at once
}

std::optional<std::string> GuardedDevice::fault() const {
  if (in_use_ && !present()) {
    return loss_.empty() ? "the device is not there" : "the device is lost: " + loss_;
  }
  return limits_.alarm();
}

}  // namespace scarab::bridge
