#pragma once

#include <memory>
#include <vector>

#include "common/robot/robot_model.hpp"
#include "services/robot_bridge/calibrate/calibrate.hpp"
#include "services/robot_bridge/config.hpp"
#include "services/robot_bridge/core/calibration.hpp"
#include "services/robot_bridge/core/driver.hpp"

namespace scarab::bridge::calibrate {

/// The robot to be calibrated, its servos speaking on their own scales. Motors are off when it
/// goes, as far as the device can switch them off.
class Bench {
 public:
  /// Loads what the request names; the device is not opened yet. Throws config::Error.
  explicit Bench(const Request& request);
  ~Bench();
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  [[nodiscard]] const BridgeConfig& config() const { return config_; }
  [[nodiscard]] const robot::RobotModel& robot() const { return robot_; }
  /// The pose that `request` names, rad.
  [[nodiscard]] const robot::JointVector& reference_rad() const { return reference_rad_; }
  /// Makes the driver with the scales that fit it and `known`.
  void set_up(const Calibration& known);

  /// After set_up().
  [[nodiscard]] Driver& driver() { return *driver_; }
  [[nodiscard]] const Calibration& scales() const { return scales_; }
  [[nodiscard]] bool tells_angles() const { return tells_angles_; }

 private:
  Request request_;
  BridgeConfig config_;
  robot::RobotModel robot_;
  robot::JointVector reference_rad_{};
  Calibration scales_;
  std::unique_ptr<Driver> driver_;
  bool tells_angles_ = false;
};

}  // namespace scarab::bridge::calibrate
