#include "tests/unit/plant/closed_loop.hpp"

#include "common/config/robot_file.hpp"
#include "services/premotor/config.hpp"
#include "services/supervisor/config.hpp"

namespace scarab::plant::testing {

ClosedLoop::ClosedLoop(const std::string& strategy, const PlantConfig& plant,
                       const TrialSpec& trial)
    : behaviour_config_(
          supervisor::load_config(SCARAB_SOURCE_DIR "/config/supervisor/beetle.yaml")),
      robot_(config::load_robot(SCARAB_SOURCE_DIR "/config/robot/beetle.yaml")),
      simulation_(robot_, plant, trial),
      machine_(behaviour_config_, supervisor::find_strategy(behaviour_config_, strategy)),
      controller_(premotor::load_config(SCARAB_SOURCE_DIR "/config/premotor/beetle.yaml"), robot_),
      behaviour_(machine_.initial_state()),
      network_(controller_.initial_state(trial.seed, true)) {}

robot::JointVector ClosedLoop::decide() {
  const Observation seen = simulation_.observe();
  supervisor::Perception perception;
  perception.tick = tick_++;
  perception.pitch_rad = seen.pitch_rad;
  perception.front_f_rad = {
      seen.position_rad[joint_slot(robot::Leg::kL0, robot::LegJoint::kFemurTibia)],
      seen.position_rad[joint_slot(robot::Leg::kR0, robot::LegJoint::kFemurTibia)]};
  perception.measured.front_angle = true;
  const supervisor::Decision decision = machine_.step(behaviour_, perception);
  if (states_.empty() || states_.back() != decision.state) states_.push_back(decision.state);
  premotor::MotorIntent intent;
  intent.inputs = decision.inputs;
  if (decision.hind_override) intent.hind_pose_rad = decision.hind_pose_rad;
  intent.backbone_rad = decision.backbone_rad;
  network_ = controller_.step(network_, intent);
  return controller_.targets(network_, intent);
}

void ClosedLoop::run() {
  while (simulation_.truth().verdict == Verdict::kOpen) simulation_.advance(decide(), nullptr);
}

}  // namespace scarab::plant::testing
