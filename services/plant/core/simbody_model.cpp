#include "services/plant/core/simbody_model.hpp"

namespace scarab::plant {
namespace {

SimTK::Vec3 to_simtk(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Eigen::Vector3d to_eigen(const SimTK::Vec3& v) { return {v[0], v[1], v[2]}; }

SimTK::Rotation to_simtk(const Eigen::Matrix3d& turn) {
  return SimTK::Rotation(SimTK::Mat33(turn(0, 0), turn(0, 1), turn(0, 2), turn(1, 0), turn(1, 1),
                                      turn(1, 2), turn(2, 0), turn(2, 1), turn(2, 2)));
}

SimTK::Body::Rigid rigid(const BodyMass& mass) {
  const Eigen::Matrix3d about_origin =
      mass.inertia_kg_m2 +
      mass.mass_kg * (mass.centre_m.squaredNorm() * Eigen::Matrix3d::Identity() -
                      mass.centre_m * mass.centre_m.transpose());
  const SimTK::Inertia inertia(about_origin(0, 0), about_origin(1, 1), about_origin(2, 2),
                               about_origin(0, 1), about_origin(0, 2), about_origin(1, 2));
  return SimTK::Body::Rigid(SimTK::MassProperties(mass.mass_kg, to_simtk(mass.centre_m), inertia));
}

/// Simbody's pin turns about z: a rotation that takes z to `axis`.
SimTK::Rotation pin_frame(const Eigen::Vector3d& axis) {
  return {SimTK::UnitVec3(to_simtk(axis)), SimTK::ZAxis};
}

}  // namespace

SimbodyModel::SimbodyModel(const Morphology& morphology)
    : matter(system), forces(system), morphology_(morphology) {
  forces.setNumberOfThreads(1);
  matter.setShowDefaultGeometry(false);
  body[kRearTrunkBody] =
      SimTK::MobilizedBody::Free(matter.Ground(), rigid(morphology.mass[kRearTrunkBody]))
          .getMobilizedBodyIndex();
  for (std::size_t i = kFrontTrunkBody; i < kObjectBody; ++i) {
    const Mounting& mount = morphology.mounting[i];
    const SimTK::Rotation R_child_pin = pin_frame(mount.axis_in_child);
    const SimTK::Rotation R_parent_pin = to_simtk(mount.R_parent_child) * R_child_pin;
    SimTK::MobilizedBody& parent = matter.updMobilizedBody(body[mount.parent]);
    body[i] = SimTK::MobilizedBody::Pin(
                  parent, SimTK::Transform(R_parent_pin, to_simtk(mount.position_in_parent)),
                  rigid(morphology.mass[i]), SimTK::Transform(R_child_pin))
                  .getMobilizedBodyIndex();
  }
  body[kObjectBody] =
      SimTK::MobilizedBody::Free(matter.Ground(), rigid(morphology.mass[kObjectBody]))
          .getMobilizedBodyIndex();
}

void SimbodyModel::finish() {
  const SimTK::State& state = system.realizeTopology();
  SimTK::State realised = state;
  system.realizeModel(realised);
  const auto first = [&](std::size_t index, int& q, int& u) {
    const SimTK::MobilizedBody& mobilised = matter.getMobilizedBody(body[index]);
    q = static_cast<int>(mobilised.getFirstQIndex(realised));
    u = static_cast<int>(mobilised.getFirstUIndex(realised));
  };
  int u = 0;
  first(kRearTrunkBody, trunk_q_, u);
  for (std::size_t k = 0; k < 6; ++k) speed_index_[kTrunkSpeed + k] = u + static_cast<int>(k);
  first(kObjectBody, object_q_, u);
  for (std::size_t k = 0; k < 6; ++k) speed_index_[kObjectSpeed + k] = u + static_cast<int>(k);
  for (std::size_t i = kFrontTrunkBody; i < kObjectBody; ++i) {
    const std::size_t slot = morphology_.mounting[i].joint_slot;
    first(i, joint_q_[slot], speed_index_[kJointSpeed + slot]);
  }
}

void SimbodyModel::write(const MotionState& motion, SimTK::State& state) const {
  SimTK::Vector& q = state.updQ();
  SimTK::Vector& u = state.updU();
  const auto free_body = [&q](int at, const Eigen::Quaterniond& turn, const Eigen::Vector3d& p) {
    q[at] = turn.w();
    q[at + 1] = turn.x();
    q[at + 2] = turn.y();
    q[at + 3] = turn.z();
    for (int k = 0; k < 3; ++k) q[at + 4 + k] = p(k);
  };
  free_body(trunk_q_, motion.trunk_orientation, motion.trunk_position);
  free_body(object_q_, motion.object_orientation, motion.object_position);
  for (std::size_t j = 0; j < robot::kJointCount; ++j) q[joint_q_[j]] = motion.joint_rad[j];
  for (std::size_t i = 0; i < kSpeedCount; ++i) {
    u[speed_index_[i]] = motion.speed(static_cast<Eigen::Index>(i));
  }
}

MotionState SimbodyModel::read(const SimTK::State& state) const {
  const SimTK::Vector& q = state.getQ();
  const SimTK::Vector& u = state.getU();
  const auto turn = [&q](int at) {
    return Eigen::Quaterniond(q[at], q[at + 1], q[at + 2], q[at + 3]).normalized();
  };
  const auto position = [&q](int at) { return Eigen::Vector3d(q[at + 4], q[at + 5], q[at + 6]); };
  MotionState out;
  out.trunk_orientation = turn(trunk_q_);
  out.trunk_position = position(trunk_q_);
  out.object_orientation = turn(object_q_);
  out.object_position = position(object_q_);
  for (std::size_t j = 0; j < robot::kJointCount; ++j) out.joint_rad[j] = q[joint_q_[j]];
  for (std::size_t i = 0; i < kSpeedCount; ++i) {
    out.speed(static_cast<Eigen::Index>(i)) = u[speed_index_[i]];
  }
  return out;
}

void SimbodyModel::read_kinematics(const SimTK::State& state, Kinematics& kinematics) const {
  for (std::size_t i = 0; i < kBodyCount; ++i) {
    const SimTK::MobilizedBody& mobilised = matter.getMobilizedBody(body[i]);
    const SimTK::Transform& pose = mobilised.getBodyTransform(state);
    const SimTK::SpatialVec& velocity = mobilised.getBodyVelocity(state);
    BodyMotion& motion = kinematics.body[i];
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column)
        motion.R_world_body(row, column) = pose.R()[row][column];
    }
    motion.position = to_eigen(pose.p());
    motion.angular_velocity = to_eigen(velocity[0]);
    motion.velocity = to_eigen(velocity[1]);
  }
  for (std::size_t i = kFrontTrunkBody; i < kObjectBody; ++i) {
    const Mounting& mount = morphology_.mounting[i];
    kinematics.joint[mount.joint_slot] = {kinematics.body[i].R_world_body * mount.axis_in_child,
                                          kinematics.body[i].position};
  }
}

}  // namespace scarab::plant
