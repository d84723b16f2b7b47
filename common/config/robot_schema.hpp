#pragma once

#include <map>
#include <optional>
#include <string>

#include "common/config/check.hpp"
#include "common/config/range.hpp"
#include "common/robot/robot_model.hpp"

/// The shape of config/robot/*.yaml. Legs are given by row, since left and right mirror each other,
/// and the joints name one of the file's servos; robot_file.hpp turns this into a
/// robot::RobotModel.
namespace scarab::robot {

/// Upper bounds are there to catch another unit (mm, g, deg), not to judge a design.
template <class Fields>
void visit_fields(Fields& f, Segment& c) {
  f("length_m", c.length_m, config::Range{0.0, 2.0});
  f("radius_m", c.radius_m, config::Range{0.0, 0.5, true});
  f("mass_kg", c.mass_kg, config::Range{0.0, 100.0, true});
}

template <class Fields>
void visit_fields(Fields& f, Trunk& c) {
  f("length_m", c.length_m, config::Range{0.0, 5.0, true});
  f("width_m", c.width_m, config::Range{0.0, 5.0, true});
  f("height_m", c.height_m, config::Range{0.0, 5.0, true});
  f("hinge_x_m", c.hinge_x_m, config::Range{-2.5, 2.5});
  f("mass_kg", c.mass_kg, config::Range{0.0, 500.0, true});
}

void validate(const Trunk& trunk, const config::Check& check);

}  // namespace scarab::robot

namespace scarab::config {

inline constexpr Range kHalfTurns{-3.141592653589793, 3.141592653589793};       // rad
inline constexpr Range kQuarterTurns{-1.5707963267948966, 1.5707963267948966};  // rad

/// One kind of servo, shared by the joints that name it.
struct ServoSchema {
  double velocity_max_rad_s = 0;
  double torque_max_nm = 0;
  double kp_nm_rad = 0;
  double kd_nm_s_rad = 0;
  double armature_kg_m2 = 0;
};

struct JointSchema {
  std::string servo;
  double min_rad = 0;
  double max_rad = 0;
};

struct LegJointsSchema {
  std::optional<JointSchema> thoraco_coxal;
  std::optional<JointSchema> coxa_trochanteral;
  std::optional<JointSchema> femur_tibia;
};

struct LegRowSchema {
  robot::LegRow body;
  LegJointsSchema joints;
};

struct LegsSchema {
  LegRowSchema front, middle, hind;
};

struct RobotSchema {
  std::string name;
  std::map<std::string, ServoSchema> servos;
  robot::Trunk trunk;
  std::optional<JointSchema> backbone;
  LegsSchema legs;
};

template <class Fields>
void visit_fields(Fields& f, ServoSchema& c) {
  f("velocity_max_rad_s", c.velocity_max_rad_s, Range{0.0, 100.0, true});
  f("torque_max_nm", c.torque_max_nm, Range{0.0, 1000.0, true});
  f("kp_nm_rad", c.kp_nm_rad, Range{0.0, 1e5, true});
  f("kd_nm_s_rad", c.kd_nm_s_rad, Range{0.0, 1e4});
  f("armature_kg_m2", c.armature_kg_m2, Range{0.0, 10.0});
}

template <class Fields>
void visit_fields(Fields& f, JointSchema& c) {
  f("servo", c.servo);
  f("min_rad", c.min_rad, kHalfTurns);
  f("max_rad", c.max_rad, kHalfTurns);
}

template <class Fields>
void visit_fields(Fields& f, LegJointsSchema& c) {
  f("thoraco_coxal", c.thoraco_coxal);
  f("coxa_trochanteral", c.coxa_trochanteral);
  f("femur_tibia", c.femur_tibia);
}

template <class Fields>
void visit_fields(Fields& f, LegRowSchema& c) {
  f("attachment_m", c.body.attachment_m, Range{-2.5, 2.5});
  f("on_front_segment", c.body.on_front_segment);
  f("mount_yaw_rad", c.body.mount_yaw_rad, kQuarterTurns);
  f("mount_elevation_rad", c.body.mount_elevation_rad, kQuarterTurns);
  f("mount_rotation_rad", c.body.mount_rotation_rad, kQuarterTurns);
  f("shoulder", c.body.shoulder);
  f("coxa", c.body.coxa);
  f("femur", c.body.femur);
  f("tibia", c.body.tibia);
  f("foot_radius_m", c.body.foot_radius_m, Range{0.0, 0.5, true});
  f("joints", c.joints);
}

template <class Fields>
void visit_fields(Fields& f, LegsSchema& c) {
  f("front", c.front);
  f("middle", c.middle);
  f("hind", c.hind);
}

template <class Fields>
void visit_fields(Fields& f, RobotSchema& c) {
  f("name", c.name);
  f("servos", c.servos);
  f("trunk", c.trunk);
  f("backbone", c.backbone);
  f("legs", c.legs);
}

void validate(const JointSchema& joint, const Check& check);
void validate(const RobotSchema& robot, const Check& check);

}  // namespace scarab::config
