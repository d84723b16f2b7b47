#pragma once

#include <array>
#include <string>

#include "common/robot/joints.hpp"

/// Morphology, limits and servos of a robot: pure data, filled from config/robot/*.yaml. The plant,
/// the command gate, the robot bridge and the generated URDF read this one description.
namespace scarab::robot {

/// Range and servo of one joint slot.
struct Joint {
  bool present = true;  ///< false: this robot lacks the joint; all else is ignored
  double min_rad = 0;
  double max_rad = 0;
  double velocity_max_rad_s = 0;  ///< slew limit of the servo
  double torque_max_nm = 0;
  double kp_nm_rad = 0;
  double kd_nm_s_rad = 0;
  double armature_kg_m2 = 0;  ///< reflected rotor inertia
};

/// A capsule along a segment.
struct Segment {
  double length_m = 0;
  double radius_m = 0;
  double mass_kg = 0;
};

/// One row of legs (front, middle or hind); left and right mirror each other.
/// Mount rotation for side s (left +1, right -1): R = Rz(-s yaw) Rx(s elevation) Ry(rotation).
struct LegRow {
  std::array<double, 3>
      attachment_m{};  ///< left leg's mount in the frame of the undivided trunk's centre; y mirrors
  bool on_front_segment = false;  ///< of the trunk, before the backbone hinge
  double mount_yaw_rad = 0;       ///< + forward
  double mount_elevation_rad = 0;
  double mount_rotation_rad = 0;  ///< about the leg's own axis; + turns "down" backward
  Segment shoulder;               ///< fixed to the trunk
  Segment coxa;                   ///< moved by the thoraco-coxal joint
  Segment femur;                  ///< moved by the coxa-trochanteral joint
  Segment tibia;                  ///< moved by the femur-tibia joint
  double foot_radius_m = 0;
};

/// Trunk: a box divided at the backbone hinge (pitch axis) into a front and a rear segment.
struct Trunk {
  double length_m = 0;
  double width_m = 0;
  double height_m = 0;
  double hinge_x_m = 0;  ///< of the hinge from the undivided trunk's centre
  double mass_kg = 0;    ///< of both segments, shared by length
};

struct RobotModel {
  std::string name;
  Trunk trunk;
  std::array<LegRow, 3> rows;  ///< front, middle, hind
  std::array<Joint, kJointCount> joints;
};

}  // namespace scarab::robot
