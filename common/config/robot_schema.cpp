#include "common/config/robot_schema.hpp"

#include <cmath>
#include <string_view>
#include <vector>

#include "common/config/error.hpp"
#include "common/config/scalar.hpp"
#include "common/config/suggestion.hpp"

namespace scarab::robot {

void validate(const Trunk& trunk, const config::Check& check) {
  check.require(std::abs(trunk.hinge_x_m) < trunk.length_m / 2, "hinge_x_m",
                "the hinge must be inside the trunk, within +-" +
                    config::format_number(trunk.length_m / 2) + " of its centre");
}

}  // namespace scarab::robot

namespace scarab::config {
namespace {

using Servos = std::map<std::string, ServoSchema>;

void check_servo(const Servos& servos, const std::optional<JointSchema>& joint,
                 const std::string& key, const Check& check) {
  if (!joint || servos.count(joint->servo) != 0) return;
  std::vector<std::string_view> names;
  for (const auto& entry : servos) names.push_back(entry.first);
  const auto near = closest(joint->servo, names);
  check.require(false, key + ".servo",
                "no servo " + in_quotes(joint->servo) + " in this file's servos" +
                    (near ? "; did you mean '" + std::string(*near) + "'?" : ""));
}

void check_leg_row(const RobotSchema& robot, const LegRowSchema& row, const std::string& key,
                   const Check& check) {
  check_servo(robot.servos, row.joints.thoraco_coxal, key + ".joints.thoraco_coxal", check);
  check_servo(robot.servos, row.joints.coxa_trochanteral, key + ".joints.coxa_trochanteral", check);
  check_servo(robot.servos, row.joints.femur_tibia, key + ".joints.femur_tibia", check);
  check.require(row.body.attachment_m[1] >= 0, key + ".attachment_m",
                "the mount is the left leg's: its y must be at least 0");
  const bool before_hinge = row.body.attachment_m[0] >= robot.trunk.hinge_x_m;
  check.require(row.body.on_front_segment == before_hinge, key + ".on_front_segment",
                before_hinge ? "must be true: the mount is before the backbone hinge"
                             : "must be false: the mount is behind the backbone hinge");
}

}  // namespace

void validate(const JointSchema& joint, const Check& check) {
  check.require(joint.min_rad < joint.max_rad, "min_rad",
                format_number(joint.min_rad) + " is not below max_rad, which is " +
                    format_number(joint.max_rad));
}

void validate(const RobotSchema& robot, const Check& check) {
  check.require(!robot.name.empty(), "name", "must not be empty");
  check_servo(robot.servos, robot.backbone, "backbone", check);
  check_leg_row(robot, robot.legs.front, "legs.front", check);
  check_leg_row(robot, robot.legs.middle, "legs.middle", check);
  check_leg_row(robot, robot.legs.hind, "legs.hind", check);
}

}  // namespace scarab::config
