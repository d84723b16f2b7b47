#include "tests/unit/plant/rig.hpp"

#include <cmath>

#include "common/config/robot_file.hpp"
#include "services/plant/config.hpp"

namespace scarab::plant::testing {

robot::RobotModel beetle() {
  return config::load_robot(SCARAB_SOURCE_DIR "/config/robot/beetle.yaml");
}

PlantConfig default_config() { return load_config(SCARAB_SOURCE_DIR "/config/plant/beetle.yaml"); }

robot::RobotModel plain_walker() {
  robot::RobotModel robot = beetle();
  for (robot::LegRow& row : robot.rows) {
    row.mount_yaw_rad = row.mount_elevation_rad = row.mount_rotation_rad = 0;
  }
  for (std::size_t j = 0; j < robot::kBackboneSlot; ++j) {
    robot.joints[j].kp_nm_rad = 40;
    robot.joints[j].kd_nm_s_rad = 0.6;
    robot.joints[j].torque_max_nm = 4;
    robot.joints[j].min_rad = -1.4;
    robot.joints[j].max_rad = 1.6;
  }
  return robot;
}

Rig::Rig(const robot::RobotModel& robot, const PlantConfig& plant_config, const Wall& wall)
    : morphology(make_morphology(robot, plant_config.object)),
      config(plant_config),
      stepper(morphology, plant_config, wall),
      state(start_state(morphology, plant_config, {})),
      targets(state.joint_rad),
      reference(state.joint_rad) {}

void Rig::run(double duration_s, double dt_s) {
  const auto steps = std::lround(duration_s / dt_s);
  for (long i = 0; i < steps; ++i) step(dt_s);
}

void Rig::remove_object() { state.object_position.y() = 50; }

void Rig::lift(double height_m) {
  state.trunk_position.z() += height_m;
  state.object_position.z() += height_m;
}

double robot_mass(const Morphology& morphology) {
  double sum = 0;
  for (std::size_t i = 0; i < kObjectBody; ++i) sum += morphology.mass[i].mass_kg;
  return sum;
}

Kinematics kinematics_of(const Morphology& morphology, const MotionState& state) {
  RobotTree tree(morphology);
  Kinematics kinematics;
  tree.update(state, kinematics);
  return kinematics;
}

MotionState odd_state(const Morphology& morphology, int variant) {
  const double phase = 0.7 * variant;
  MotionState state;
  state.trunk_position = Eigen::Vector3d(0.3 + variant, -0.2, 5);
  state.trunk_orientation = Eigen::Quaterniond(0.8, 0.3, -0.4, 0.2 + 0.1 * variant).normalized();
  state.object_position = Eigen::Vector3d(-0.7, 0.4, 6);
  state.object_orientation = Eigen::Quaterniond(0.5, -0.4, 0.6, 0.1).normalized();
  for (std::size_t j = 0; j < robot::kJointCount; ++j) {
    const robot::Joint& joint = morphology.joints[j];
    const double share = 0.5 + 0.45 * std::sin(phase + 1.3 * static_cast<double>(j));
    state.joint_rad[j] = joint.min_rad + share * (joint.max_rad - joint.min_rad);
  }
  for (Eigen::Index i = 0; i < state.speed.size(); ++i) {
    state.speed(i) = 1.5 * std::sin(phase + 2.1 * static_cast<double>(i));
  }
  return state;
}

}  // namespace scarab::plant::testing
