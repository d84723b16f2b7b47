#pragma once

#include <array>
#include <limits>
#include <string>

#include "common/robot/joints.hpp"

/// What a robot tells of itself, in SI units and the project's signs (common/robot/joints.hpp).
namespace scarab::bridge {

/// Where a value comes from: a device measured it, it is what the device was last told, or nobody
/// knows it.
enum class Source { kAbsent, kMeasured, kCommanded };

/// One quantity of every joint slot; values without a source mean nothing, and go out as 0.
struct JointReadings {
  robot::JointVector value{};
  std::array<Source, robot::kJointCount> source{};  ///< kAbsent unless said otherwise
};

/// One number for each joint slot, none of them known.
constexpr robot::JointVector unknown_of_each_joint() {
  robot::JointVector values{};
  for (double& value : values) value = std::numeric_limits<double>::quiet_NaN();
  return values;
}

/// What one exchange with the device has brought.
struct Readings {
  JointReadings position_rad;
  JointReadings velocity_rad_s;
  JointReadings torque_nm;

  robot::LegVector foot_force_n{};
  std::array<Source, robot::kLegCount> foot_force_source{};

  double roll_rad = 0;
  double pitch_rad = 0;
  Source imu_source = Source::kAbsent;  ///< of roll and pitch
  std::array<double, 3> angular_velocity_rad_s{};
  std::array<double, 3> acceleration_m_s2{};
  Source motion_source = Source::kAbsent;  ///< of the two above

  double supply_current_a = 0;  ///< of the whole robot
  Source supply_current_source = Source::kAbsent;

  robot::JointVector temperature_c = unknown_of_each_joint();  ///< NaN where the device is silent
  robot::JointVector current_a = unknown_of_each_joint();      ///< NaN where the device is silent

  /// Not empty: a device reports an error of its own (overload, overheating), named with its joint.
  std::string device_error;
};

}  // namespace scarab::bridge
