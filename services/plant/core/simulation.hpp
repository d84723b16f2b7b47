#pragma once

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

/// One trial's physics: robot, cylinder, obstacle, referee. No clock, no bus, no randomness but of the seed.
class Simulation {
 public:
  /// The robot stands in front of the cylinder, settled, at the perturbed start pose of the trial.
  /// `start_targets`: joint targets (rad) it stands in.
  /// Throws std::invalid_argument naming what is inconsistent.
  Simulation(const robot::RobotModel& robot, const PlantConfig& config, const TrialSpec& trial);
  ~Simulation();

  [[nodiscard]] Observation observe() const;   ///< what the robot's sensors read now (adapter: robot_state)
  [[nodiscard]] WorldTruth truth() const;      ///< ground truth and the referee's verdict (adapter: world_state)
  [[nodiscard]] std::int64_t time_ns() const;

  /// Simulates one control tick towards `targets` (rad, joint slots; zero-order hold); calls `sample` after
  /// every sensor period inside it, but for the one that ends the tick (that is the next tick's robot_state).
  void advance(const robot::JointVector& targets, const std::function<void()>& sample);
};

}  // namespace scarab::plant
