#pragma once

#include <array>

#include "services/plant/core/sensor_config.hpp"

namespace scarab::plant {

/// Periods of the simulation. Each is a whole number of nanoseconds; the sensor period is a
/// multiple of the step and the control period one of the sensor period.
struct TimingConfig {
  double step_s = 0.002;
  double sensor_period_s = 0.02;
  double control_period_s = 0.1;
};

/// Normal force of one contact point: max(0, stiffness * depth + damping * closing speed).
struct NormalContact {
  double stiffness_n_m = 0;
  double damping_n_s_m = 0;
};

/// Contact law (contact_law.hpp).
struct ContactConfig {
  NormalContact robot;  ///< of each point on the robot, against anything
  NormalContact
      object;  ///< of the cylinder on ground and obstacle, all points of its axis together
  double slip_speed_m_s = 0.002;           ///< friction grows linearly up to this speed
  double anchor_stiffness_n_m = 0;         ///< of Cundall-Strack friction anchors; 0: no anchors
  double object_rolling_resistance_m = 0;  ///< lever arm: torque per normal force
  double trunk_edge_radius_m = 0;          ///< rounding of the trunk's edges
};

/// Coulomb friction coefficient of each pair of surfaces.
struct FrictionConfig {
  double foot_ground = 0;   ///< foot and tibia
  double trunk_ground = 0;  ///< trunk, coxa and femur
  double foot_object = 0;   ///< foot and tibia
  double trunk_object = 0;  ///< trunk, coxa and femur
  double leg_obstacle = 0;  ///< any part of the robot
  double leg_leg = 0;
  double object_ground = 0;
  double object_obstacle = 0;
};

/// Mechanical stop at either end of a joint's range.
struct JointStopConfig {
  double stiffness_nm_rad = 0;
  double damping_nm_s_rad = 0;
};

/// The cylinder. Its axis lies across the path, along y.
struct ObjectConfig {
  double length_m = 0;
  double diameter_m = 0;
  double mass_kg = 0;
  double start_distance_m = 0;  ///< of its axis behind the trunk's centre
};

/// A thin wall across the path, without end to either side. Its height comes with the trial.
struct ObstacleConfig {
  double thickness_m = 0;
  double gap_m = 0;  ///< from the object's far surface at the start to the wall's middle
};

/// How the robot stands before the first command: T, C, F of each row of legs.
struct StartConfig {
  std::array<double, 3> front_rad{};
  std::array<double, 3> middle_rad{};
  std::array<double, 3> hind_rad{};
  double backbone_rad = 0;
  double settle_s = 0;  ///< simulated before t = 0 with the stance as target
};

/// What the robot draws from its supply (supply_current.hpp).
struct SupplyConfig {
  double idle_a = 0;                ///< with no torque anywhere
  double torque_constant_nm_a = 1;  ///< of each servo, at its joint
};

/// Limits by which the referee judges a trial.
struct RefereeConfig {
  double across_margin_m = 0;      ///< the object's axis this far past the obstacle is across
  double lost_distance_m = 0;      ///< from the trunk's end to the object's axis
  double lost_sideways_m = 0;      ///< between trunk end and the object's middle, across the path
  double overturned_tilt_rad = 0;  ///< of the trunk's vertical against gravity
};

struct PlantConfig {
  double gravity_m_s2 = 9.81;
  TimingConfig timing;
  ContactConfig contact;
  FrictionConfig friction;
  JointStopConfig joint_stop;
  ObjectConfig object;
  ObstacleConfig obstacle;
  StartConfig start;
  SupplyConfig supply;
  SensorsConfig sensors;
  CommandPathConfig commands;
  RefereeConfig referee;
};

}  // namespace scarab::plant
