#include "services/plant/core/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "common/random/random.hpp"
#include "services/plant/core/forward_kinematics.hpp"

namespace scarab::plant {
namespace {

double uniform_within(double bound, std::uint64_t seed, std::uint64_t stream) {
  return bound * (2 * random::uniform(seed, stream, 0) - 1);
}

void require_size(double value, const char* name) {
  if (std::isfinite(value) && value >= 0) return;
  throw std::invalid_argument("the trial's " + std::string(name) + " is " + std::to_string(value) +
                              ": it must be positive, or 0 for the configured one");
}

void change_friction(FrictionConfig& friction, const TrialSpec& trial) {
  const double scale = trial.friction_scale > 0 ? trial.friction_scale : 1;
  const auto change = [&](double& coefficient, const char* name) {
    coefficient *=
        scale * (1 + uniform_within(trial.perturb_friction, trial.seed, random::stream(name)));
  };
  change(friction.foot_ground, "friction_foot_ground");
  change(friction.trunk_ground, "friction_trunk_ground");
  change(friction.foot_object, "friction_foot_object");
  change(friction.trunk_object, "friction_trunk_object");
  change(friction.leg_obstacle, "friction_leg_obstacle");
  change(friction.leg_leg, "friction_leg_leg");
  change(friction.object_ground, "friction_object_ground");
  change(friction.object_obstacle, "friction_object_obstacle");
}

/// Height of the lowest foot's lowest point.
double lowest_foot(const Morphology& morphology, const MotionState& state) {
  Kinematics kinematics;
  ForwardKinematics(morphology).update(state, kinematics);
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

PlantConfig scene_config(PlantConfig config, const TrialSpec& trial) {
  require_size(trial.friction_scale, "friction scale");
  require_size(trial.object_mass_kg, "object mass");
  require_size(trial.object_diameter_m, "object diameter");
  if (!(trial.perturb_friction >= 0 && trial.perturb_friction < 1)) {
    throw std::invalid_argument("the trial's perturbation of friction is " +
                                std::to_string(trial.perturb_friction) + ": it must be in [0, 1)");
  }
  change_friction(config.friction, trial);
  if (trial.object_mass_kg > 0) config.object.mass_kg = trial.object_mass_kg;
  if (trial.object_diameter_m > 0) config.object.diameter_m = trial.object_diameter_m;
  if (trial.goal == Goal::kWalk) config.object.start_distance_m += trial.goal_distance_m + 1;
  return config;
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
                        const Perturbation& perturbation, const robot::JointVector& joint_rad) {
  MotionState state;
  state.joint_rad = joint_rad;
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

MotionState start_state(const Morphology& morphology, const PlantConfig& config,
                        const Perturbation& perturbation) {
  return start_state(morphology, config, perturbation, start_targets(config.start));
}

}  // namespace scarab::plant
