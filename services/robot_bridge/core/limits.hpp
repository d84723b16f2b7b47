#pragma once

#include <optional>
#include <string>

#include "services/robot_bridge/core/confirmed_alarm.hpp"
#include "services/robot_bridge/core/readings.hpp"

namespace scarab::bridge {

/// Beyond these the robot is brought to its safe stop. None: not watched.
struct LimitsConfig {
  /// So many readings in a row beyond a limit raise the alarm, so many within it clear it: one bad
  /// reading stops no robot. From cause to alarm it takes at most this many sensor periods.
  unsigned confirm_readings = 3;
  /// Within a limit again is what lies below this fraction of it.
  double clear_fraction = 0.9;
  std::optional<double> temperature_max_c;     ///< of any joint's servo
  std::optional<double> joint_current_max_a;   ///< of any joint's servo
  std::optional<double> supply_current_max_a;  ///< of the whole robot
  std::optional<double> inclination_max_rad;   ///< the larger of roll and pitch, either way
};

/// What of the robot's own state forbids it to go on: heat, current, inclination, an error that a
/// device reports of itself.
class Limits {
 public:
  explicit Limits(const LimitsConfig& config);

  /// Judges one exchange's readings. A quantity that they do not tell neither raises nor clears.
  void observe(const Readings& readings);
  /// The device was closed: nothing of the past counts against the next one.
  void forget();

  /// Why the robot must not go on, one phrase with the joint, the value and the limit; none: it
  /// may.
  [[nodiscard]] std::optional<std::string> alarm() const;

 private:
  LimitsConfig config_;
  ConfirmedAlarm device_;
  ConfirmedAlarm temperature_;
  ConfirmedAlarm joint_current_;
  ConfirmedAlarm supply_current_;
  ConfirmedAlarm inclination_;
};

}  // namespace scarab::bridge
