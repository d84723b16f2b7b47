// The linearly implicit stepper against a plain Simbody integrator on the same forces.
#include <gtest/gtest.h>

#include <algorithm>

#include "services/plant/core/contact_jacobian.hpp"
#include "services/plant/core/simbody_model.hpp"
#include "tests/unit/plant/rig.hpp"

namespace scarab::plant {
namespace {

using testing::Rig;

/// Contact, servos, stops and gravity as an ordinary Simbody force: the laws of the plant in their
/// limit of a vanishing step, evaluated at the integrator's own state.
class PlantForce : public SimTK::Force::Custom::Implementation {
 public:
  PlantForce(const SimbodyModel& model, const Rig& rig, const Wall& wall)
      : model_(model),
        morphology_(rig.morphology),
        config_(rig.config),
        targets_(rig.targets),
        mass_matrix_(rig.morphology),
        collision_(rig.morphology, wall, rig.config.contact.trunk_edge_radius_m),
        law_(rig.config.contact, rig.config.friction) {}

  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& /*body_forces*/,
                 SimTK::Vector_<SimTK::Vec3>& /*particle_forces*/,
                 SimTK::Vector& mobility_forces) const override {
    Kinematics kinematics;
    model_.read_kinematics(state, kinematics);
    const MotionState motion = model_.read(state);
    SpeedMatrix unused;
    SpeedVector force;
    mass_matrix_.compute(kinematics, config_.gravity_m_s2, unused, force);
    add_joints(motion, force);
    add_contacts(kinematics, motion.speed, force);
    for (std::size_t i = 0; i < kSpeedCount; ++i) {
      mobility_forces[model_.speed_index()[i]] += force(static_cast<Eigen::Index>(i));
    }
  }

  SimTK::Real calcPotentialEnergy(const SimTK::State& /*state*/) const override { return 0; }

 private:
  void add_joints(const MotionState& motion, SpeedVector& force) const {
    for (std::size_t j = 0; j < robot::kJointCount; ++j) {
      const auto at = static_cast<Eigen::Index>(kJointSpeed + j);
      const robot::Joint& joint = morphology_.joints[j];
      const double angle = motion.joint_rad[j], speed = motion.speed(at);
      const JointTorque servo = servo_torque(joint, targets_[j], angle, speed, 0);
      const JointTorque stop = stop_torque(config_.joint_stop, joint, angle, speed, 0);
      force(at) += servo.torque_nm + stop.torque_nm -
                   (servo.damping_nm_s_rad + stop.damping_nm_s_rad) * speed;
    }
  }

  void add_contacts(const Kinematics& kinematics, const SpeedVector& speed,
                    SpeedVector& force) const {
    std::vector<Contact> contacts;
    collision_.detect(kinematics, contacts);
    law_.begin_step();
    const BodyMotion& object = kinematics.body[kObjectBody];
    const Eigen::Vector3d axis = object.R_world_body.col(1);
    const double spin = object.angular_velocity.dot(axis);
    for (const Contact& contact : contacts) {
      const ContactJacobian jacobian(kinematics, morphology_.leg_on_front, contact);
      const Eigen::Vector3d velocity = jacobian.velocity(speed);
      const ContactForce law =
          law_.evaluate(contact, velocity, spin, morphology_.object_radius_m, 0);
      jacobian.add_force(force_on_b(law, contact.touch.normal, velocity), force);
      force.segment<3>(static_cast<Eigen::Index>(kObjectSpeed)) -=
          law.rolling_damping * spin * axis;
    }
  }

  const SimbodyModel& model_;
  Morphology morphology_;
  PlantConfig config_;
  robot::JointVector targets_;
  MassMatrix mass_matrix_;
  mutable Collision collision_;
  mutable ContactLaw law_;
};

double rearmost_foot(const Rig& rig) {
  const Kinematics kinematics = testing::kinematics_of(rig.morphology, rig.state);
  double x = rig.state.trunk_position.x();
  for (const robot::Leg leg : robot::kLegs) {
    const std::size_t tibia = leg_body(leg, LegSegment::kTibia);
    x = std::min(x, kinematics.body[tibia].to_world(rig.morphology.segment[tibia].tip).x());
  }
  return x;
}

/// A crouch that also kicks the object, which stands right behind the robot.
Rig make_rig() {
  robot::RobotModel robot = testing::beetle();
  for (robot::Joint& joint : robot.joints) {
    joint.armature_kg_m2 = 0;  // Simbody's pins have none
    joint.velocity_max_rad_s = 1e9;
  }
  Rig rig(robot, testing::default_config());
  rig.state.object_position.x() = rearmost_foot(rig) - rig.morphology.object_radius_m - 0.03;
  for (const robot::Leg leg : robot::kLegs) {
    rig.targets[joint_slot(leg, robot::LegJoint::kThoracoCoxal)] -=
        robot::row(leg) == 2 ? 1.0 : 0.3;
    rig.targets[joint_slot(leg, robot::LegJoint::kFemurTibia)] += 0.2;
  }
  return rig;
}

TEST(Stepper, AgreesWithAPlainSimbodyIntegrator) {
  Rig rig = make_rig();
  const MotionState start = rig.state;
  SimbodyModel model(rig.morphology);
  SimTK::Force::Custom force(model.forces, new PlantForce(model, rig, {}));  // Simbody owns it
  model.finish();
  SimTK::State initial = model.system.getDefaultState();
  model.write(start, initial);
  SimTK::RungeKuttaMersonIntegrator integrator(model.system);
  integrator.setAccuracy(1e-4);
  SimTK::TimeStepper stepper(model.system, integrator);
  stepper.initialize(initial);

  for (const double time : {0.1, 0.2, 0.3}) {
    stepper.stepTo(time);
    rig.run(0.1, 1e-4);
    const MotionState expected = model.read(integrator.getState());
    EXPECT_NEAR((rig.state.trunk_position - expected.trunk_position).norm(), 0, 3e-4) << time;
    EXPECT_NEAR(rig.state.trunk_orientation.angularDistance(expected.trunk_orientation), 0, 3e-3);
    EXPECT_NEAR((rig.state.object_position - expected.object_position).norm(), 0, 3e-4) << time;
    for (std::size_t j = 0; j < robot::kJointCount; ++j) {
      EXPECT_NEAR(rig.state.joint_rad[j], expected.joint_rad[j], 3e-3) << robot::kJointNames[j];
    }
  }
  EXPECT_GT((rig.state.trunk_position - start.trunk_position).norm(), 0.01) << "it must have moved";
  EXPECT_GT((rig.state.object_position - start.object_position).norm(), 0.005) << "and kicked";
}

}  // namespace
}  // namespace scarab::plant
