// The robot's parts are solid to each other, to the object and to the wall.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/plant/rig.hpp"

namespace scarab::plant {
namespace {

using robot::Leg;
using robot::LegJoint;
using testing::Rig;

constexpr double kDt = 0.002;

Capsule segment(const Rig& rig, const Kinematics& kinematics, Leg leg, LegSegment which) {
  const std::size_t body = leg_body(leg, which);
  const SegmentShape& shape = rig.morphology.segment[body];
  return {kinematics.body[body].position, kinematics.body[body].to_world(shape.tip),
          shape.radius_m};
}

/// Deepest overlap of any segments of two different legs.
double leg_overlap(const Rig& rig, const MotionState& state) {
  const Kinematics kinematics = testing::kinematics_of(rig.morphology, state);
  double deepest = 0;
  for (const Leg first : robot::kLegs) {
    for (const Leg second : robot::kLegs) {
      if (first >= second) continue;
      for (const LegSegment i : {LegSegment::kCoxa, LegSegment::kFemur, LegSegment::kTibia}) {
        for (const LegSegment j : {LegSegment::kCoxa, LegSegment::kFemur, LegSegment::kTibia}) {
          const auto touch = touch_capsules(segment(rig, kinematics, first, i),
                                            segment(rig, kinematics, second, j));
          if (touch) deepest = std::max(deepest, touch->depth);
        }
      }
    }
  }
  return deepest;
}

bool touches(const Rig& rig, Solid a, Solid b) {
  for (const ResolvedContact& contact : rig.stepper.contacts()) {
    if (contact.contact.a.solid == a && contact.contact.b.solid == b) return true;
  }
  return false;
}

/// A walk whose T-joints swing neighbouring legs across each other.
robot::JointVector crossing_walk(double time_s, const robot::JointVector& stance) {
  robot::JointVector targets = stance;
  for (const Leg leg : robot::kLegs) {
    const double phase = 2 * 3.14159265358979 * 0.7 * time_s;
    const double sweep = (robot::row(leg) == 1 ? 1 : -1) * std::sin(phase);
    targets[joint_slot(leg, LegJoint::kThoracoCoxal)] = 1.4 * sweep;
    targets[joint_slot(leg, LegJoint::kFemurTibia)] = 0.9;
  }
  return targets;
}

TEST(LegsAndLegs, DoNotPassThroughEachOther) {
  Rig rig(testing::plain_walker(), testing::default_config());
  rig.remove_object();
  const robot::JointVector stance = rig.targets;
  double told = 0, done = 0;
  bool touched = false;
  for (int i = 0; i < 3000; ++i) {
    rig.targets = crossing_walk(i * kDt, stance);
    rig.step(kDt);
    touched = touched || touches(rig, Solid::kTibia, Solid::kTibia);
    if (i % 5 != 0) continue;
    MotionState obedient = rig.state;
    obedient.joint_rad = rig.targets;
    told = std::max(told, leg_overlap(rig, obedient));
    done = std::max(done, leg_overlap(rig, rig.state));
  }
  EXPECT_GT(told, 0.020) << "the targets must have asked for it";
  EXPECT_TRUE(touched);
  EXPECT_LT(done, 0.005) << "of 0.026 when axes cross";
}

TEST(LegsAndObject, EveryPartPushesIt) {
  // The object is dropped on the robot's back: legs and trunk carry it.
  PlantConfig config = testing::default_config();
  Rig rig(testing::beetle(), config);
  rig.state.object_position = rig.state.trunk_position + Eigen::Vector3d(-0.05, 0, 0.16);
  bool on_trunk = false, on_leg = false;
  for (int i = 0; i < 400; ++i) {
    rig.step(kDt);
    on_trunk = on_trunk || touches(rig, Solid::kObject, Solid::kTrunk);
    for (const Solid part : {Solid::kCoxa, Solid::kFemur, Solid::kTibia}) {
      on_leg = on_leg || touches(rig, Solid::kObject, part);
    }
    const Kinematics kinematics = testing::kinematics_of(rig.morphology, rig.state);
    const BodyMotion& body = kinematics.body[kObjectBody];
    const Cylinder object{body.position, body.R_world_body.col(1), 0.09, 0.3};
    for (const Leg leg : robot::kLegs) {
      for (const LegSegment part : {LegSegment::kCoxa, LegSegment::kFemur, LegSegment::kTibia}) {
        const auto touch = touch_cylinder(object, segment(rig, kinematics, leg, part));
        EXPECT_LT(touch ? touch->depth : 0, 0.006);
      }
    }
  }
  EXPECT_TRUE(on_trunk);
  EXPECT_TRUE(on_leg);
}

TEST(RobotAndWall, FeetAndTrunkDoNotPass) {
  // Pulled backward against a wall higher than itself, 1 mm thin.
  const Wall wall{-0.30, 0.0005, 0.5};
  Rig rig(testing::beetle(), testing::default_config(), wall);
  rig.remove_object();
  const robot::JointVector stance = rig.targets;
  bool touched = false;
  for (int i = 0; i < 3000; ++i) {
    for (const Leg leg : robot::kLegs) {  // a walk, backward
      const double phase =
          2 * 3.14159265358979 * i * kDt + (tripod_sign(leg) > 0 ? 0 : 3.14159265358979);
      rig.targets[joint_slot(leg, LegJoint::kThoracoCoxal)] = -0.5 * std::sin(phase);
      rig.targets[joint_slot(leg, LegJoint::kCoxaTrochanteral)] =
          stance[joint_slot(leg, LegJoint::kCoxaTrochanteral)] +
          0.35 * std::max(0.0, std::cos(phase));
    }
    rig.step(kDt);
    for (const Solid part : {Solid::kTrunk, Solid::kTibia, Solid::kFoot, Solid::kFemur}) {
      touched = touched || touches(rig, Solid::kObstacle, part);
    }
    const Kinematics kinematics = testing::kinematics_of(rig.morphology, rig.state);
    EXPECT_GT(kinematics.body[kRearTrunkBody].to_world(rig.morphology.rear_box.low).x(),
              wall.x - 0.004);
    for (const Leg leg : {Leg::kL2, Leg::kR2}) {
      EXPECT_GT(segment(rig, kinematics, leg, LegSegment::kTibia).b.x(), wall.x);
    }
  }
  EXPECT_TRUE(touched);
}

TEST(RobotOnItsBack, LiesOnItsCoxae) {
  Rig rig(testing::beetle(), testing::default_config());
  rig.remove_object();
  rig.state.trunk_orientation =
      Eigen::Quaterniond(Eigen::AngleAxisd(3.14159265358979, Eigen::Vector3d::UnitX()));
  rig.state.trunk_position.z() = 0.06;
  rig.run(1, kDt);
  EXPECT_GT(rig.state.trunk_position.z(), 0.03);
  EXPECT_TRUE(touches(rig, Solid::kGround, Solid::kCoxa)) << "they stand above the trunk";
}

}  // namespace
}  // namespace scarab::plant
