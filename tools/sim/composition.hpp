#pragma once

#include <functional>

#include "common/robot/robot_model.hpp"
#include "services/plant/core/plant_config.hpp"
#include "services/premotor/core/premotor_controller.hpp"
#include "services/supervisor/core/supervisor_config.hpp"
#include "tools/sim/sample_log.hpp"

namespace scarab::sim {

struct Configuration {
  robot::RobotModel robot;
  plant::PlantConfig plant;
  premotor::PremotorConfig premotor;
  supervisor::SupervisorConfig supervisor;
};

/// Sees every sample of the chain that a report is made from.
struct Listener {
  std::function<void(const scarab_Behaviour&)> behaviour;
  std::function<void(const scarab_WorldState&)> world;
  std::function<bool()> interrupted;  ///< asked once a tick; true ends the trial where it is
};

/// Runs one trial with the services' cores, adapters and the command gate in this one process: the
/// same samples, byte by byte and wall-clock stamps aside, that the separate processes exchange.
/// Throws std::exception for a trial that cannot be run.
void run_trial(const Configuration& configuration, const scarab_Trial& trial, SampleLog& log,
               const Listener& listener);

}  // namespace scarab::sim
