#pragma once

#include <memory>
#include <string>
#include <vector>

#include "services/plant/core/simulation.hpp"
#include "services/premotor/core/premotor_controller.hpp"
#include "services/supervisor/core/behaviour_machine.hpp"

namespace scarab::plant::testing {

/// The chain of plant, supervisor and premotor controller on their cores alone, with the project's
/// own configuration: one trial, tick by tick, without bus, gate or log.
class ClosedLoop {
 public:
  ClosedLoop(const std::string& strategy, const PlantConfig& plant, const TrialSpec& trial);

  /// What the controller answers to what the plant's sensors read now.
  [[nodiscard]] robot::JointVector decide();

  /// Runs the trial to its verdict.
  void run();

  [[nodiscard]] Simulation& plant() { return simulation_; }

  /// Behaviours in the order in which they were entered.
  [[nodiscard]] const std::vector<supervisor::State>& states() const { return states_; }

 private:
  supervisor::SupervisorConfig behaviour_config_;
  robot::RobotModel robot_;
  Simulation simulation_;
  supervisor::BehaviourMachine machine_;
  premotor::PremotorController controller_;
  supervisor::MachineState behaviour_;
  premotor::NetworkState network_;
  std::vector<supervisor::State> states_;
  std::uint32_t tick_ = 0;
};

}  // namespace scarab::plant::testing
