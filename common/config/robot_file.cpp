#include "common/config/robot_file.hpp"

#include <array>
#include <stdexcept>

#include "common/config/config.hpp"
#include "common/config/robot_schema.hpp"

namespace scarab::config {
namespace {

using robot::Joint;
using robot::LegJoint;
using Servos = std::map<std::string, ServoSchema>;

Joint to_joint(const Servos& servos, const std::optional<JointSchema>& schema) {
  Joint joint;
  joint.present = schema.has_value();
  if (!schema) return joint;
  const ServoSchema& servo = servos.at(schema->servo);
  joint.min_rad = schema->min_rad;
  joint.max_rad = schema->max_rad;
  joint.velocity_max_rad_s = servo.velocity_max_rad_s;
  joint.torque_max_nm = servo.torque_max_nm;
  joint.kp_nm_rad = servo.kp_nm_rad;
  joint.kd_nm_s_rad = servo.kd_nm_s_rad;
  joint.armature_kg_m2 = servo.armature_kg_m2;
  return joint;
}

robot::RobotModel to_model(const RobotSchema& schema) {
  robot::RobotModel model;
  model.name = schema.name;
  model.trunk = schema.trunk;
  const std::array<const LegRowSchema*, 3> rows = {&schema.legs.front, &schema.legs.middle,
                                                   &schema.legs.hind};
  for (std::size_t i = 0; i < rows.size(); ++i) model.rows[i] = rows[i]->body;
  for (const robot::Leg leg : robot::kLegs) {
    const LegJointsSchema& joints = rows[robot::row(leg)]->joints;
    const auto slot = [&](LegJoint joint) -> Joint& {
      return model.joints[robot::joint_slot(leg, joint)];
    };
    slot(LegJoint::kThoracoCoxal) = to_joint(schema.servos, joints.thoraco_coxal);
    slot(LegJoint::kCoxaTrochanteral) = to_joint(schema.servos, joints.coxa_trochanteral);
    slot(LegJoint::kFemurTibia) = to_joint(schema.servos, joints.femur_tibia);
  }
  model.joints[robot::kBackboneSlot] = to_joint(schema.servos, schema.backbone);
  return model;
}

bool same_servo(const ServoSchema& a, const ServoSchema& b) {
  return a.velocity_max_rad_s == b.velocity_max_rad_s && a.torque_max_nm == b.torque_max_nm &&
         a.kp_nm_rad == b.kp_nm_rad && a.kd_nm_s_rad == b.kd_nm_s_rad &&
         a.armature_kg_m2 == b.armature_kg_m2;
}

/// Name of this joint's servo among `servos`, where it is added if it is new.
std::string servo_of(const Joint& joint, Servos& servos) {
  const ServoSchema servo = {joint.velocity_max_rad_s, joint.torque_max_nm, joint.kp_nm_rad,
                             joint.kd_nm_s_rad, joint.armature_kg_m2};
  for (const auto& [name, known] : servos) {
    if (same_servo(known, servo)) return name;
  }
  std::string name = "servo_" + std::to_string(servos.size() + 1);
  servos[name] = servo;
  return name;
}

std::optional<JointSchema> to_schema(const Joint& joint, Servos& servos) {
  if (!joint.present) return std::nullopt;
  return JointSchema{servo_of(joint, servos), joint.min_rad, joint.max_rad};
}

bool same_joint(const Joint& a, const Joint& b) {
  Servos servos;
  const auto first = to_schema(a, servos);
  const auto second = to_schema(b, servos);
  if (!first || !second) return first.has_value() == second.has_value();
  return first->servo == second->servo && a.min_rad == b.min_rad && a.max_rad == b.max_rad;
}

LegRowSchema row_schema(const robot::RobotModel& model, std::size_t row, Servos& servos) {
  const auto left = static_cast<robot::Leg>(row);
  const auto right = static_cast<robot::Leg>(row + 3);
  const auto joint = [&](LegJoint which) {
    const Joint& from = model.joints[robot::joint_slot(left, which)];
    if (!same_joint(from, model.joints[robot::joint_slot(right, which)])) {
      throw std::invalid_argument("dump_robot: left and right joints differ in leg row " +
                                  std::to_string(row));
    }
    return to_schema(from, servos);
  };
  return {model.rows[row],
          {joint(LegJoint::kThoracoCoxal), joint(LegJoint::kCoxaTrochanteral),
           joint(LegJoint::kFemurTibia)}};
}

}  // namespace

robot::RobotModel load_robot(const std::filesystem::path& path) {
  return to_model(load<RobotSchema>(path));
}

robot::RobotModel load_robot_text(const std::string& file, const std::string& text) {
  return to_model(load_text<RobotSchema>(file, text));
}

std::string dump_robot(const robot::RobotModel& model) {
  RobotSchema schema;
  schema.name = model.name;
  schema.trunk = model.trunk;
  schema.legs.front = row_schema(model, 0, schema.servos);
  schema.legs.middle = row_schema(model, 1, schema.servos);
  schema.legs.hind = row_schema(model, 2, schema.servos);
  schema.backbone = to_schema(model.joints[robot::kBackboneSlot], schema.servos);
  return dump(schema);
}

}  // namespace scarab::config
