#include "services/robot_bridge/drivers/loopback/driver.hpp"

#include <algorithm>

namespace scarab::bridge::loopback {
namespace {

constexpr double kGravity_m_s2 = 9.81;
constexpr double kRoomTemperature_c = 25;

/// Where the servos are at first, on their own scales: as they are really mounted.
robot::JointVector first_angles(const Config& config, const Calibration& calibration) {
  robot::JointVector angles{};
  for (std::size_t joint = 0; joint < robot::kJointCount; ++joint) {
    const auto& c = calibration.joints[joint];
    if (!c) continue;
    const std::string name(robot::kJointNames[joint]);
    const auto pose = config.pose_rad.find(name);
    const auto mounting = config.mounting.find(name);
    const double joint_rad = pose == config.pose_rad.end() ? 0 : pose->second;
    angles[joint] = mounting == config.mounting.end()
                        ? c->offset_rad + turned(*c, joint_rad)
                        : mounting->second.offset_rad + mounting->second.direction * joint_rad;
  }
  return angles;
}

}  // namespace

std::optional<std::size_t> joint_of(std::string_view name) {
  const auto found = std::find(robot::kJointNames.begin(), robot::kJointNames.end(), name);
  if (found == robot::kJointNames.end()) return std::nullopt;
  return static_cast<std::size_t>(found - robot::kJointNames.begin());
}

bool needs_joint(FaultKind kind) {
  return kind == FaultKind::kHot || kind == FaultKind::kCurrent || kind == FaultKind::kStuck ||
         kind == FaultKind::kError;
}

LoopbackDriver::LoopbackDriver(Config config, const robot::RobotModel& robot,
                               const Calibration& calibration)
    : config_(std::move(config)),
      calibration_(of_robot(calibration, robot)),
      servos_(robot, first_angles(config_, calibration_)) {}

bool LoopbackDriver::is_on(const Fault& fault) const {
  if (!first_active_) return false;
  const double age_s = std::chrono::duration<double>(Clock::now() - *first_active_).count();
  return fault.after_s <= age_s && age_s < fault.after_s + fault.for_s;
}

bool LoopbackDriver::is_on(FaultKind kind) const {
  return std::any_of(config_.faults.begin(), config_.faults.end(),
                     [&](const Fault& fault) { return fault.kind == kind && is_on(fault); });
}

void LoopbackDriver::advance() {
  const auto now = Clock::now();
  for (const Fault& fault : config_.faults) {
    if (fault.kind == FaultKind::kStuck) servos_.set_stuck(*joint_of(*fault.joint), is_on(fault));
  }
  servos_.advance(std::chrono::duration<double>(now - advanced_).count());
  advanced_ = now;
}

void LoopbackDriver::catch_up() {
  if (!open_) throw DeviceError("loopback: not open");
  advance();
  if (is_on(FaultKind::kLost)) throw DeviceError("loopback: lost, as configured");
}

void LoopbackDriver::open() {
  const std::chrono::duration<double> age = Clock::now() - made_;
  if (age.count() < config_.appears_after_s || is_on(FaultKind::kLost)) {
    throw DeviceError("loopback: not there, as configured");
  }
  open_ = true;
  servos_.set_torque(false);
  advanced_ = Clock::now();
}

void LoopbackDriver::close() noexcept { open_ = false; }

void LoopbackDriver::add_joints(Readings& readings) const {
  for (std::size_t joint = 0; joint < robot::kJointCount; ++joint) {
    if (!calibration_.joints[joint]) continue;
    const JointCalibration& c = *calibration_.joints[joint];
    readings.position_rad.value[joint] = to_joint_rad(c, servos_.angle_rad()[joint]);
    readings.velocity_rad_s.value[joint] = turned(c, servos_.velocity_rad_s()[joint]);
    readings.position_rad.source[joint] = Source::kMeasured;
    readings.velocity_rad_s.source[joint] = Source::kMeasured;
    readings.temperature_c[joint] = kRoomTemperature_c;
    readings.current_a[joint] = 0;
  }
}

void LoopbackDriver::add_faults(Readings& readings) const {
  for (const Fault& fault : config_.faults) {
    if (!is_on(fault)) continue;
    const std::size_t joint = fault.joint ? *joint_of(*fault.joint) : 0;
    if (fault.kind == FaultKind::kHot) readings.temperature_c[joint] = fault.value;
    if (fault.kind == FaultKind::kCurrent) readings.current_a[joint] = fault.value;
    if (fault.kind == FaultKind::kSupply) readings.supply_current_a = fault.value;
    if (fault.kind == FaultKind::kTilt) readings.pitch_rad = fault.value;
    if (fault.kind == FaultKind::kError) readings.device_error = *fault.joint + ": as configured";
  }
}

Readings LoopbackDriver::read() {
  catch_up();
  ++reads_;
  Readings readings;
  add_joints(readings);
  readings.acceleration_m_s2 = {0, 0, kGravity_m_s2};
  readings.imu_source = Source::kMeasured;
  readings.motion_source = Source::kMeasured;
  readings.supply_current_source = Source::kMeasured;
  add_faults(readings);
  return readings;
}

void LoopbackDriver::activate(const robot::JointVector& hold_rad) {
  write(hold_rad);
  servos_.set_torque(true);
  if (!first_active_) first_active_ = Clock::now();
}

void LoopbackDriver::write(const robot::JointVector& target_rad) {
  catch_up();
  ++writes_;
  robot::JointVector goals{};
  for (std::size_t joint = 0; joint < robot::kJointCount; ++joint) {
    if (calibration_.joints[joint])
      goals[joint] = to_servo_rad(*calibration_.joints[joint], target_rad[joint]);
  }
  servos_.set_goals(goals);
}

bool LoopbackDriver::hold() noexcept {
  if (!open_ || is_on(FaultKind::kDeaf) || is_on(FaultKind::kLost)) return false;
  advance();
  servos_.stop();
  return true;
}

bool LoopbackDriver::release() noexcept {
  if (!open_ || is_on(FaultKind::kDeaf) || is_on(FaultKind::kLost)) return false;
  advance();
  servos_.set_torque(false);
  return true;
}

Capabilities LoopbackDriver::capabilities() const {
  Capabilities able;
  able.position_feedback = true;
  able.velocity_feedback = true;
  able.imu = true;
  able.temperature = true;
  able.joint_current = true;
  able.supply_current = true;
  able.torque_switch = true;
  able.link = "loopback, no device";
  return able;
}

std::vector<std::pair<std::string, std::uint64_t>> LoopbackDriver::counters() const {
  return {{"loopback_reads", reads_}, {"loopback_writes", writes_}};
}

std::unique_ptr<Driver> make(const Config& config, const robot::RobotModel& robot,
                             const Calibration& calibration,
                             const std::string& /*device_override*/) {
  return std::make_unique<LoopbackDriver>(config, robot, calibration);
}

}  // namespace scarab::bridge::loopback
