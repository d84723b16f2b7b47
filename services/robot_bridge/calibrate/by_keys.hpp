#pragma once

#include <chrono>
#include <cstddef>
#include <optional>

#include "common/robot/robot_model.hpp"
#include "services/robot_bridge/calibrate/console.hpp"
#include "services/robot_bridge/calibrate/finding.hpp"
#include "services/robot_bridge/calibrate/measures.hpp"
#include "services/robot_bridge/core/driver.hpp"

namespace scarab::bridge::calibrate {

/// Calibration of a robot that does not tell where its joints are: a person drives each servo with
/// the keys + and - until the joint looks right, at two places.
class ByKeys {
 public:
  /// One press of a key, and the fastest a servo is told to turn.
  static constexpr double kStep_rad = 0.02;
  static constexpr double kSpeed_rad_s = 0.5;

  /// `driver`: made with the servos' own scales `nominal` (own_scales()), open. `known`: the file
  /// as it is. `reference_rad`: the pose of the first look. `pace`: between two steps of the goals.
  ByKeys(Driver& driver, Console& console, const robot::RobotModel& robot,
         const Calibration& nominal, const Calibration& known,
         const robot::JointVector& reference_rad,
         std::chrono::milliseconds pace = std::chrono::milliseconds(50));

  /// Warns, and switches the motors on after Enter: every joint then moves to where the file says
  /// that the reference pose is. False: the person would rather not. Throws DeviceError,
  /// Interrupted.
  [[nodiscard]] bool power();

  /// After power(). Throws DeviceError, Interrupted.
  [[nodiscard]] Finding find(std::size_t joint);

 private:
  struct Look {
    Key key = Key::kNone;
    Standing standing;
  };

  /// Moves the joint as the keys say until Enter, s, k or q.
  [[nodiscard]] Look drive(std::size_t joint, double joint_rad);
  /// Takes keys until it is time for a step, or one of them ends the look.
  [[nodiscard]] Key keys_until_step(double& wanted_rad, const JointCalibration& travel);
  /// All goals a little on towards where they are wanted.
  void approach();

  Driver& driver_;
  Console& console_;
  const robot::RobotModel& robot_;
  Calibration nominal_;
  Calibration known_;
  robot::JointVector reference_rad_;
  std::chrono::milliseconds pace_;
  robot::JointVector wanted_rad_{};  ///< of the servos
  robot::JointVector goal_rad_{};    ///< told to the servos last
};

}  // namespace scarab::bridge::calibrate
