#pragma once

#include <cstdint>
#include <string_view>

#include "services/robot_bridge/core/driver.hpp"

namespace scarab::bridge {

/// As in ros2_control: the device is not there; its states are readable and its motors off; its
/// motors are on; the end.
enum class LifecycleState { kUnconfigured, kInactive, kActive, kFinalised };

[[nodiscard]] std::string_view name_of(LifecycleState state) noexcept;

/// What the motors do in a safe stop: hold where they stand, or have no torque.
enum class SafeStop { kHold, kRelease };

/// Leads a driver through its lifecycle, so that motors are on in one state only, and so that every
/// error ends in one where they are off as far as the device can still be told:
///
///     unconfigured --configure--> inactive --activate--> active --deactivate--> inactive
///     inactive, active --DeviceError, give_up--> unconfigured      any --finalise--> finalised
///
/// A call that its state does not allow throws std::logic_error and touches no device.
class Lifecycle {
 public:
  /// `safe_stop`: what becomes of the motors when the device fails while they are on.
  Lifecycle(Driver& driver, SafeStop safe_stop) : driver_(driver), safe_stop_(safe_stop) {}
  Lifecycle(const Lifecycle&) = delete;
  Lifecycle& operator=(const Lifecycle&) = delete;
  ~Lifecycle() { finalise(); }

  /// Opens the device. Throws DeviceError; then it stays unconfigured.
  void configure();
  /// Motors on, holding `hold_rad`; those that are on already (after hold()) stay on. Throws
  /// DeviceError; then they are off again, and the device is inactive, or unconfigured if it did
  /// not even confirm that.
  void activate(const robot::JointVector& hold_rad);
  /// One exchange. Throws DeviceError; then it is unconfigured.
  Readings read();
  /// New goals. Throws DeviceError; then it is unconfigured.
  void write(const robot::JointVector& target_rad);
  /// Safe stop with torque: it stays active. False: the device did not confirm it. Does nothing
  /// unless active.
  bool hold() noexcept;
  /// Motors off. False: the device did not confirm it; one without a switch is not asked to. Does
  /// nothing unless active.
  bool deactivate() noexcept;
  /// The device is closed without another word to it: its own time-out does the rest.
  void give_up() noexcept;
  /// Motors off, device closed, for good.
  void finalise() noexcept;

  [[nodiscard]] LifecycleState state() const noexcept { return state_; }
  /// Times that a device which was there has failed.
  [[nodiscard]] std::uint64_t failures() const noexcept { return failures_; }
  /// Stops that the device did not confirm.
  [[nodiscard]] std::uint64_t unconfirmed_stops() const noexcept { return unconfirmed_stops_; }

 private:
  [[noreturn]] void refuse(std::string_view call) const;
  [[nodiscard]] bool open() const noexcept;
  bool confirmed(bool by_device) noexcept;
  void fail() noexcept;

  Driver& driver_;
  SafeStop safe_stop_;
  bool has_torque_switch_ = false;
  LifecycleState state_ = LifecycleState::kUnconfigured;
  std::uint64_t failures_ = 0;
  std::uint64_t unconfirmed_stops_ = 0;
};

}  // namespace scarab::bridge
