#include "services/plant/core/scene.hpp"

#include <algorithm>
#include <limits>

#include "common/random/random.hpp"
#include "services/plant/core/robot_tree.hpp"

namespace scarab::plant {
namespace {

double uniform_within(double bound, std::uint64_t seed, std::uint64_t stream) {
  return bound * (2 * random::uniform(seed, stream, 0) - 1);
}

/// Height of the lowest foot's lowest point.
double lowest_foot(const Morphology& morphology, const MotionState& state) {
  RobotTree tree(morphology);
  Kinematics kinematics;
  tree.update(state, kinematics);
  double lowest = std::numeric_limits<double>::infinity();
  for (const robot::Leg leg : robot::kLegs) {
    const std::size_t tibia = leg_body(leg, LegSegment::kTibia);
    const Eigen::Vector3d foot = kinematics.body[tibia].to_world(morphology.segment[tibia].tip);
    lowest = std::min(lowest, foot.z() - morphology.foot_radius_m[robot::leg_slot(leg)]);
  }
  return lowest;
}

}  // namespace

Perturbation perturbation(const TrialSpec& trial) {
  return {uniform_within(trial.perturb_position_m, trial.seed, random::stream("start_x")),
          uniform_within(trial.perturb_position_m, trial.seed, random::stream("start_y")),
          uniform_within(trial.perturb_yaw_rad, trial.seed, random::stream("start_yaw"))};
}

Wall make_wall(const PlantConfig& config, const TrialSpec& trial) {
  Wall wall;
  wall.x =
      -(config.object.start_distance_m + 0.5 * config.object.diameter_m + config.obstacle.gap_m);
  wall.half_thickness = 0.5 * config.obstacle.thickness_m;
  wall.height = trial.obstacle_height_m;
  return wall;
}

robot::JointVector start_targets(const StartConfig& start) {
  robot::JointVector targets{};
  const std::array<const std::array<double, 3>*, 3> rows = {&start.front_rad, &start.middle_rad,
                                                            &start.hind_rad};
  for (const robot::Leg leg : robot::kLegs) {
    for (std::size_t k = 0; k < 3; ++k) {
      targets[joint_slot(leg, static_cast<robot::LegJoint>(k))] = (*rows[robot::row(leg)])[k];
    }
  }
  targets[robot::kBackboneSlot] = start.backbone_rad;
  return targets;
}

MotionState start_state(const Morphology& morphology, const PlantConfig& config,
                        const Perturbation& perturbation) {
  MotionState state;
  state.joint_rad = start_targets(config.start);
  for (std::size_t j = 0; j < robot::kJointCount; ++j) {
    if (!morphology.joints[j].present) state.joint_rad[j] = 0;
  }
  state.trunk_orientation =
      Eigen::Quaterniond(Eigen::AngleAxisd(perturbation.yaw_rad, Eigen::Vector3d::UnitZ()));
  state.trunk_position = Eigen::Vector3d(perturbation.x_m, perturbation.y_m, 0);
  state.trunk_position.z() = -lowest_foot(morphology, state);
  state.object_position =
      Eigen::Vector3d(-config.object.start_distance_m, 0, morphology.object_radius_m);
  return state;
}

}  // namespace scarab::plant
