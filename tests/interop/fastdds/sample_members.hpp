#pragma once

#include <behaviour.h>
#include <header.h>
#include <joint_command.h>
#include <neural_activity.h>
#include <operator.h>
#include <robot_state.h>
#include <service_status.h>
#include <trial.h>
#include <world_state.h>

/// The members of the IDL's structs by name: fastddsgen makes one function of each.
namespace scarab::fastdds {

template <class F>
void for_each_member(const Header& s, F&& f) {
  f("trial", s.trial());
  f("tick", s.tick());
  f("sim_time_ns", s.sim_time_ns());
  f("stamp_ns", s.stamp_ns());
}

template <class F>
void for_each_member(const Behaviour& s, F&& f) {
  f("header", s.header());
  f("real_time", s.real_time());
  f("mode", s.mode());
  f("inputs", s.inputs());
  f("hind_override", s.hind_override());
  f("hind_pose_rad", s.hind_pose_rad());
  f("backbone_rad", s.backbone_rad());
  f("state", s.state());
  f("entered_tick", s.entered_tick());
  f("reason", s.reason());
  f("bs_rad", s.bs_rad());
  f("bs_threshold_rad", s.bs_threshold_rad());
  f("as_rad", s.as_rad());
  f("as_threshold_rad", s.as_threshold_rad());
  f("trigger", s.trigger());
  f("trigger_value", s.trigger_value());
  f("trigger_threshold", s.trigger_threshold());
}

template <class F>
void for_each_member(const JointCommand& s, F&& f) {
  f("header", s.header());
  f("kind", s.kind());
  f("position_rad", s.position_rad());
}

template <class F>
void for_each_member(const NeuralActivity& s, F&& f) {
  f("header", s.header());
  f("input", s.input());
  f("cpg", s.cpg());
  f("psn1", s.psn1());
  f("psn2", s.psn2());
  f("psn3", s.psn3());
  f("psn4", s.psn4());
  f("vrn1", s.vrn1());
  f("vrn2", s.vrn2());
  f("delay_line", s.delay_line());
  f("motor", s.motor());
}

template <class F>
void for_each_member(const Operator& s, F&& f) {
  f("header", s.header());
  f("command", s.command());
  f("mode", s.mode());
  f("inputs", s.inputs());
  f("strategy", s.strategy());
  f("reason", s.reason());
}

template <class F>
void for_each_member(const RobotState& s, F&& f) {
  f("header", s.header());
  f("phase", s.phase());
  f("real_time", s.real_time());
  f("position_rad", s.position_rad());
  f("velocity_rad_s", s.velocity_rad_s());
  f("torque_nm", s.torque_nm());
  f("position_source", s.position_source());
  f("velocity_source", s.velocity_source());
  f("torque_source", s.torque_source());
  f("foot_force_n", s.foot_force_n());
  f("foot_force_source", s.foot_force_source());
  f("inclination_rad", s.inclination_rad());
  f("angular_velocity_rad_s", s.angular_velocity_rad_s());
  f("acceleration_m_s2", s.acceleration_m_s2());
  f("imu_source", s.imu_source());
  f("motion_source", s.motion_source());
  f("supply_current_a", s.supply_current_a());
  f("supply_current_source", s.supply_current_source());
}

template <class F>
void for_each_member(const Counter& s, F&& f) {
  f("name", s.name());
  f("value", s.value());
}

template <class F>
void for_each_member(const Histogram& s, F&& f) {
  f("name", s.name());
  f("count", s.count());
  f("sum_s", s.sum_s());
  f("max_s", s.max_s());
}

template <class F>
void for_each_member(const ServiceStatus& s, F&& f) {
  f("header", s.header());
  f("service", s.service());
  f("instance", s.instance());
  f("lifecycle", s.lifecycle());
  f("ready_trial", s.ready_trial());
  f("recorded_trial", s.recorded_trial());
  f("recorded_tick", s.recorded_tick());
  f("health", s.health());
  f("message", s.message());
  f("process_id", s.process_id());
  f("counters", s.counters());
  f("histograms", s.histograms());
}

template <class F>
void for_each_member(const Trial& s, F&& f) {
  f("header", s.header());
  f("strategy", s.strategy());
  f("goal", s.goal());
  f("goal_distance_m", s.goal_distance_m());
  f("time_limit_s", s.time_limit_s());
  f("obstacle_height_m", s.obstacle_height_m());
  f("seed", s.seed());
  f("perturb_position_m", s.perturb_position_m());
  f("perturb_yaw_rad", s.perturb_yaw_rad());
  f("perturb_cpg_phase", s.perturb_cpg_phase());
  f("perturb_friction", s.perturb_friction());
  f("friction_scale", s.friction_scale());
  f("object_mass_kg", s.object_mass_kg());
  f("object_diameter_m", s.object_diameter_m());
}

template <class F>
void for_each_member(const Pose& s, F&& f) {
  f("position_m", s.position_m());
  f("orientation_wxyz", s.orientation_wxyz());
}

template <class F>
void for_each_member(const Twist& s, F&& f) {
  f("linear_m_s", s.linear_m_s());
  f("angular_rad_s", s.angular_rad_s());
}

template <class F>
void for_each_member(const Contact& s, F&& f) {
  f("solid_a", s.solid_a());
  f("leg_a", s.leg_a());
  f("solid_b", s.solid_b());
  f("leg_b", s.leg_b());
  f("point_m", s.point_m());
  f("force_n", s.force_n());
  f("depth_m", s.depth_m());
}

template <class F>
void for_each_member(const WorldState& s, F&& f) {
  f("header", s.header());
  f("trunk", s.trunk());
  f("trunk_twist", s.trunk_twist());
  f("object", s.object());
  f("object_twist", s.object_twist());
  f("object_travel_m", s.object_travel_m());
  f("obstacle_present", s.obstacle_present());
  f("obstacle_x_m", s.obstacle_x_m());
  f("obstacle_height_m", s.obstacle_height_m());
  f("contacts", s.contacts());
  f("contacts_dropped", s.contacts_dropped());
  f("verdict", s.verdict());
  f("verdict_time_s", s.verdict_time_s());
  f("verdict_reason", s.verdict_reason());
}

}  // namespace scarab::fastdds
