#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "common/robot/joints.hpp"
#include "services/robot_bridge/core/driver.hpp"
#include "services/robot_bridge/core/lifecycle.hpp"
#include "services/robot_bridge/core/limits.hpp"
#include "services/robot_bridge/core/readings.hpp"

namespace scarab::bridge {

/// A robot's device as the bridge uses it: looked for until it is there, read and watched, and
/// written only while its motors are on and nobody has stopped it. A device that fails, whatever
/// its driver throws, is a fact that fault() tells, not an exception. Times come from outside.
class GuardedDevice {
 public:
  /// First and longest pause between two attempts to open a device that is not there, s.
  static constexpr double kFirstPause_s = 0.25;
  static constexpr double kLongestPause_s = 2.0;

  /// `home_rad`: where joints are taken to stand of which nobody knows anything: the robot is put
  /// there by hand before its motors are first switched on.
  GuardedDevice(Driver& driver, SafeStop safe_stop, const LimitsConfig& limits,
                const robot::JointVector& home_rad);

  /// Opens a device that is not there, if it is time to try again; `now_s` never goes back.
  void look_for(double now_s);
  /// One exchange, judged by the limits; nothing while the device is not there.
  void exchange();
  /// Of the last exchange; blank, all sources absent, while the device is not there.
  [[nodiscard]] const Readings& readings() const { return readings_; }
  [[nodiscard]] LifecycleState state() const noexcept { return lifecycle_.state(); }
  [[nodiscard]] bool present() const noexcept;

  /// Motors on, where the joints stand. Throws DeviceError, and with the device's own reason where
  /// fault() forbids it; then they are off.
  void activate();
  /// New goals; nothing after a safe stop or while the device is not there.
  void apply(const robot::JointVector& target_rad);
  /// The robot stands still, or is without torque, and no goal is written until activate(). A
  /// device that does not confirm it is given up.
  void safe_stop() noexcept;
  /// Motors off.
  void rest() noexcept;

  /// What forbids to go on, in words that stay the same while it lasts.
  [[nodiscard]] std::optional<std::string> fault() const;
  /// Why the device is not there; empty before the first attempt and while it is.
  [[nodiscard]] const std::string& absence() const noexcept { return absence_; }
  /// Where the joints stand as goals, rad: the last ones written.
  [[nodiscard]] const robot::JointVector& held_rad() const noexcept { return held_rad_; }

  [[nodiscard]] std::uint64_t losses() const noexcept { return lifecycle_.failures(); }
  [[nodiscard]] std::uint64_t unconfirmed_stops() const noexcept {
    return lifecycle_.unconfirmed_stops();
  }

 private:
  void lose(const std::string& why) noexcept;
  [[nodiscard]] robot::JointVector standing_rad() const;

  SafeStop safe_stop_;
  Lifecycle lifecycle_;
  Limits limits_;
  Readings readings_;
  robot::JointVector held_rad_;
  bool in_use_ = false;   ///< between activate() and rest(): a loss is a fault
  bool stopped_ = false;  ///< by safe_stop()
  std::string loss_;      ///< why it was lost last
  std::string absence_;   ///< why it is not there now
  double pause_s_ = 0;    ///< until the next attempt to open
  double attempt_s_ = 0;  ///< when it was made last
};

}  // namespace scarab::bridge
