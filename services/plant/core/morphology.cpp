#include "services/plant/core/morphology.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace scarab::plant {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using robot::Leg;
using robot::LegJoint;

void require_positive(double value, const std::string& name) {
  if (!(std::isfinite(value) && value > 0)) {
    throw std::invalid_argument(name + " must be positive, is " + std::to_string(value));
  }
}

/// Inertia about the centre of a solid rod along the unit vector `axis`.
Matrix3d rod_inertia(double mass, double length, double radius, const Vector3d& axis) {
  const double along = 0.5 * mass * radius * radius;
  const double across = mass * (3 * radius * radius + length * length) / 12;
  return across * Matrix3d::Identity() + (along - across) * axis * axis.transpose();
}

BodyMass box_mass(const TrunkBox& box, double mass) {
  const Vector3d size = box.high - box.low;
  const Vector3d square = size.cwiseProduct(size);
  const Vector3d diagonal(square.y() + square.z(), square.x() + square.z(),
                          square.x() + square.y());
  return {mass, 0.5 * (box.low + box.high), Matrix3d((mass / 12 * diagonal).asDiagonal())};
}

/// Two rigidly joined bodies as one, both in the same frame.
BodyMass joined(const BodyMass& a, const BodyMass& b) {
  BodyMass sum;
  sum.mass_kg = a.mass_kg + b.mass_kg;
  sum.centre_m = (a.mass_kg * a.centre_m + b.mass_kg * b.centre_m) / sum.mass_kg;
  for (const BodyMass* part : {&a, &b}) {
    const Vector3d offset = part->centre_m - sum.centre_m;
    sum.inertia_kg_m2 +=
        part->inertia_kg_m2 +
        part->mass_kg * (offset.squaredNorm() * Matrix3d::Identity() - offset * offset.transpose());
  }
  return sum;
}

void check(const robot::RobotModel& robot, const ObjectConfig& object) {
  const robot::Trunk& trunk = robot.trunk;
  require_positive(trunk.length_m, "trunk length");
  require_positive(trunk.width_m, "trunk width");
  require_positive(trunk.height_m, "trunk height");
  require_positive(trunk.mass_kg, "trunk mass");
  if (!(std::abs(trunk.hinge_x_m) < 0.5 * trunk.length_m)) {
    throw std::invalid_argument("trunk hinge lies outside the trunk");
  }
  for (const robot::LegRow& row : robot.rows) {
    // The shoulder alone may have no length: a thoraco-coxal joint inside the trunk.
    if (row.shoulder.length_m != 0) require_positive(row.shoulder.length_m, "shoulder length");
    for (const robot::Segment* segment : {&row.coxa, &row.femur, &row.tibia}) {
      require_positive(segment->length_m, "leg segment length");
    }
    for (const robot::Segment* segment : {&row.shoulder, &row.coxa, &row.femur, &row.tibia}) {
      require_positive(segment->radius_m, "leg segment radius");
      require_positive(segment->mass_kg, "leg segment mass");
    }
    require_positive(row.foot_radius_m, "foot radius");
  }
  require_positive(object.length_m, "object length");
  require_positive(object.diameter_m, "object diameter");
  require_positive(object.mass_kg, "object mass");
}

void lay_out_trunk(const robot::Trunk& trunk, Morphology& out) {
  const Vector3d half = 0.5 * Vector3d(trunk.length_m, trunk.width_m, trunk.height_m);
  const double front_length = half.x() - trunk.hinge_x_m;
  out.rear_box = {-half, Vector3d(trunk.hinge_x_m, half.y(), half.z())};
  out.front_box = {Vector3d(0, -half.y(), -half.z()), Vector3d(front_length, half.y(), half.z())};
  const double front_mass = trunk.mass_kg * front_length / trunk.length_m;
  out.mass[kRearTrunkBody] = box_mass(out.rear_box, trunk.mass_kg - front_mass);
  out.mass[kFrontTrunkBody] = box_mass(out.front_box, front_mass);
  // Positive backbone angle raises the rear against the front: the front turns about -y.
  out.mounting[kFrontTrunkBody] = {kRearTrunkBody, Matrix3d::Identity(),
                                   Vector3d(trunk.hinge_x_m, 0, 0), -Vector3d::UnitY(),
                                   robot::kBackboneSlot};
}

void lay_out_segment(const robot::Segment& shape, const Vector3d& outward, std::size_t body,
                     Morphology& out) {
  out.segment[body] = {shape.length_m * outward, shape.radius_m};
  out.mass[body] = {shape.mass_kg, 0.5 * shape.length_m * outward,
                    rod_inertia(shape.mass_kg, shape.length_m, shape.radius_m, outward)};
}

void lay_out_leg(const robot::RobotModel& robot, Leg leg, Morphology& out) {
  const robot::LegRow& row = robot.rows[robot::row(leg)];
  const double side = robot::is_left(leg) ? 1 : -1;
  const Vector3d outward = side * Vector3d::UnitY();
  const std::size_t trunk = row.on_front_segment ? kFrontTrunkBody : kRearTrunkBody;
  Vector3d attachment(row.attachment_m[0], side * row.attachment_m[1], row.attachment_m[2]);
  if (row.on_front_segment) attachment.x() -= robot.trunk.hinge_x_m;
  const Matrix3d R_mount = (AngleAxisd(-side * row.mount_yaw_rad, Vector3d::UnitZ()) *
                            AngleAxisd(side * row.mount_elevation_rad, Vector3d::UnitX()) *
                            AngleAxisd(row.mount_rotation_rad, Vector3d::UnitY()))
                               .toRotationMatrix();
  const BodyMass shoulder{row.shoulder.mass_kg,
                          attachment + R_mount * (0.5 * row.shoulder.length_m * outward),
                          rod_inertia(row.shoulder.mass_kg, row.shoulder.length_m,
                                      row.shoulder.radius_m, R_mount * outward)};
  out.mass[trunk] = joined(out.mass[trunk], shoulder);

  const std::size_t coxa = leg_body(leg, LegSegment::kCoxa);
  const std::size_t femur = leg_body(leg, LegSegment::kFemur);
  const std::size_t tibia = leg_body(leg, LegSegment::kTibia);
  lay_out_segment(row.coxa, outward, coxa, out);
  lay_out_segment(row.femur, outward, femur, out);
  lay_out_segment(row.tibia, outward, tibia, out);
  // T + forward, C + up, F + down, on either side.
  const Matrix3d straight = Matrix3d::Identity();
  out.mounting[coxa] = {trunk, R_mount, attachment + R_mount * (row.shoulder.length_m * outward),
                        -side * Vector3d::UnitZ(), joint_slot(leg, LegJoint::kThoracoCoxal)};
  out.mounting[femur] = {coxa, straight, out.segment[coxa].tip, side * Vector3d::UnitX(),
                         joint_slot(leg, LegJoint::kCoxaTrochanteral)};
  out.mounting[tibia] = {femur, straight, out.segment[femur].tip, -side * Vector3d::UnitX(),
                         joint_slot(leg, LegJoint::kFemurTibia)};
  out.foot_radius_m[robot::leg_slot(leg)] = row.foot_radius_m;
  out.leg_on_front[robot::leg_slot(leg)] = row.on_front_segment;
}

}  // namespace

Morphology make_morphology(const robot::RobotModel& robot, const ObjectConfig& object) {
  check(robot, object);
  Morphology out;
  out.joints = robot.joints;
  lay_out_trunk(robot.trunk, out);
  for (const Leg leg : robot::kLegs) lay_out_leg(robot, leg, out);
  out.object_radius_m = 0.5 * object.diameter_m;
  out.object_half_length_m = 0.5 * object.length_m;
  out.mass[kObjectBody] = {
      object.mass_kg, Vector3d::Zero(),
      rod_inertia(object.mass_kg, object.length_m, out.object_radius_m, Vector3d::UnitY())};
  return out;
}

}  // namespace scarab::plant
