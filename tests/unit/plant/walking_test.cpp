// The tripod walk of the robot's reference figures.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/plant/rig.hpp"

namespace scarab::plant {
namespace {

using testing::Rig;

constexpr double kPi = 3.14159265358979;
constexpr double kFrequencyHz = 0.6;

/// T = 0.35 sin(phase), C = 0.35 max(0, cos(phase)), tripods in anti-phase.
robot::JointVector walk(double time_s, const robot::JointVector& stance) {
  robot::JointVector targets = stance;
  for (const robot::Leg leg : robot::kLegs) {
    const double phase = 2 * kPi * kFrequencyHz * time_s + (tripod_sign(leg) > 0 ? 0 : kPi);
    targets[joint_slot(leg, robot::LegJoint::kThoracoCoxal)] = 0.35 * std::sin(phase);
    targets[joint_slot(leg, robot::LegJoint::kCoxaTrochanteral)] =
        0.35 * std::max(0.0, std::cos(phase));
  }
  return targets;
}

struct Walk {
  double distance_m = 0;
  double tilt_rad = 0;  ///< largest after the first second
};

Walk walk_for(double duration_s, double dt) {
  PlantConfig config = testing::default_config();
  config.friction.foot_ground = 0.8;
  config.start.front_rad = config.start.middle_rad = config.start.hind_rad = {0, 0, 1.4};
  config.start.backbone_rad = 0;
  Rig rig(testing::plain_walker(), config);
  rig.remove_object();
  rig.run(1, dt);
  const robot::JointVector stance = rig.targets;
  const double start = rig.state.trunk_position.x();
  Walk out;
  for (long i = 0; i < std::lround(duration_s / dt); ++i) {
    const double time = static_cast<double>(i) * dt;
    rig.targets = walk(time, stance);
    rig.step(dt);
    const Eigen::Vector3d up = rig.state.trunk_orientation * Eigen::Vector3d::UnitZ();
    if (time > 1) out.tilt_rad = std::max(out.tilt_rad, std::acos(std::min(1.0, up.z())));
  }
  out.distance_m = rig.state.trunk_position.x() - start;
  return out;
}

TEST(Walking, DistanceConvergesOverTheStep) {
  const Walk fine = walk_for(5, 0.0005);
  EXPECT_GT(fine.distance_m, 0.35);
  for (const double dt : {0.001, 0.002, 0.004}) {
    EXPECT_NEAR(walk_for(5, dt).distance_m, fine.distance_m, 0.01 * fine.distance_m) << dt;
  }
}

TEST(Walking, StaysLevel) { EXPECT_LT(walk_for(5, 0.002).tilt_rad, 0.035); }

}  // namespace
}  // namespace scarab::plant
