#pragma once

#include <bitset>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/robot/robot_model.hpp"
#include "services/plant/core/observation.hpp"
#include "services/plant/core/plant_config.hpp"
#include "services/plant/core/trial_spec.hpp"
#include "services/plant/core/world_truth.hpp"

namespace scarab::plant {

/// One trial's physics: robot, cylinder, obstacle, referee. No clock, no bus, no randomness but of
/// the seed.
class Simulation {
 public:
  /// The robot stands in front of the cylinder at the perturbed start pose of the trial, settled in
  /// the configured stance (config.start) for config.start.settle_s before t = 0. Throws
  /// std::invalid_argument naming what is inconsistent.
  Simulation(const robot::RobotModel& robot, const PlantConfig& config, const TrialSpec& trial);
  /// The same with the joints at `start_rad` (rad, joint slots) in place of the configured stance.
  Simulation(const robot::RobotModel& robot, const PlantConfig& config, const TrialSpec& trial,
             const robot::JointVector& start_rad);
  ~Simulation();
  Simulation(Simulation&& other) noexcept;
  Simulation& operator=(Simulation&& other) noexcept;
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  [[nodiscard]] Observation observe()
      const;  ///< what the robot's sensors read now (adapter: robot_state)
  [[nodiscard]] WorldTruth truth()
      const;  ///< ground truth, the referee's verdict (adapter: world_state)
  [[nodiscard]] std::int64_t time_ns() const;

  /// Which servos have power from now on, by joint slot; all have it at the start. A servo without
  /// gives no torque, and when its power comes back it begins from where its joint then is.
  void power(const std::bitset<robot::kJointCount>& powered);

  /// Simulates one control tick towards `targets` (rad, joint slots; zero-order hold); calls
  /// `sample`, if given, after every sensor period inside it, but for the one that ends the tick
  /// (that is the next tick's robot_state). The referee judges at the end of the tick; its verdict
  /// is latched. Throws std::runtime_error if the motion is no longer finite.
  void advance(const robot::JointVector& targets, const std::function<void()>& sample);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scarab::plant
