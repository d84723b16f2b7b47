#include "tools/emulator/boards/dynamixel/board.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

namespace scarab::emulator {
namespace {

JointMotion motion_of(const plant::Observation& body, std::size_t joint) {
  return {body.position_rad[joint], body.velocity_rad_s[joint], body.torque_nm[joint]};
}

void show_motion(SensorBoard& imu, const dxl::ImuConfig& items, const plant::Observation& body,
                 double tilt_rad) {
  imu.show(items.roll, body.roll_rad);
  imu.show(items.pitch, body.pitch_rad + tilt_rad);
  for (std::size_t axis = 0; axis < items.acceleration.size(); ++axis) {
    imu.show(items.angular_velocity[axis], body.angular_velocity_rad_s[axis]);
    imu.show(items.acceleration[axis], body.acceleration_m_s2[axis]);
  }
}

}  // namespace

DynamixelBoard::DynamixelBoard(const dxl::Config& config, const robot::RobotModel& robot,
                               const bridge::Calibration& calibration, Note note)
    : config_(config), note_(std::move(note)), bus_(note_) {
  add_servos(robot, calibration);
  add_sensor_boards();
  for (const auto& servo : servos_) bus_.add(*servo);
  if (imu_) bus_.add(*imu_);
  if (feet_) bus_.add(*feet_);
}

void DynamixelBoard::add_servos(const robot::RobotModel& robot,
                                const bridge::Calibration& calibration) {
  for (std::size_t j = 0; j < robot::kJointCount; ++j) {
    if (!robot.joints[j].present) continue;
    const std::string name(robot::kJointNames[j]);
    const auto servo = config_.servos.find(name);
    if (servo == config_.servos.end()) throw std::invalid_argument("no servo for " + name);
    if (!calibration.joints[j]) throw std::invalid_argument("no calibration of " + name);
    const auto model = dxl::find_model(config_, servo->second.model);
    if (!model) throw std::invalid_argument("no such model of a servo: " + servo->second.model);
    servos_.push_back(std::make_unique<Servo>(
        *model, ServoPlace{j, servo->second.id, *calibration.joints[j]}, note_));
  }
}

void DynamixelBoard::add_sensor_boards() {
  if (config_.imu) {
    imu_.emplace(config_.imu->id);
    imu_->add(config_.imu->roll);
    imu_->add(config_.imu->pitch);
    for (const dxl::Item& item : config_.imu->angular_velocity) imu_->add(item);
    for (const dxl::Item& item : config_.imu->acceleration) imu_->add(item);
  }
  if (config_.foot_force) {
    feet_.emplace(config_.foot_force->id);
    for (const dxl::Item& item : config_.foot_force->force) feet_->add(item);
  }
}

std::string DynamixelBoard::description() const {
  return std::to_string(servos_.size()) + " DYNAMIXEL servos" + (imu_ ? ", an IMU" : "") +
         (feet_ ? ", a board for the feet" : "") + " on one bus";
}

std::uint64_t DynamixelBoard::power_ups() const {
  std::uint64_t sum = 0;
  for (const auto& servo : servos_) sum += servo->power_ups();
  return sum;
}

void DynamixelBoard::on_byte(std::uint8_t byte, std::int64_t now_ns, std::vector<Reply>& replies) {
  bus_.feed(byte, now_ns, replies);
  update_drive();
}

void DynamixelBoard::tick(std::int64_t now_ns) {
  for (const auto& servo : servos_) servo->tick(now_ns);
  update_drive();
}

std::int64_t DynamixelBoard::next_tick_ns() const {
  std::int64_t next_ns = std::numeric_limits<std::int64_t>::max();
  for (const auto& servo : servos_) {
    if (const auto due_ns = servo->watchdog_ns()) next_ns = std::min(next_ns, *due_ns + 1);
  }
  return next_ns;
}

void DynamixelBoard::sense(const plant::Observation& body) {
  for (const auto& servo : servos_) servo->sense(motion_of(body, servo->joint()));
  if (imu_) show_motion(*imu_, *config_.imu, body, effects_.tilt_rad);
  for (std::size_t leg = 0; feet_ && leg < robot::kLegCount; ++leg) {
    feet_->show(config_.foot_force->force[leg], body.foot_force_n[leg]);
  }
  update_drive();
}

void DynamixelBoard::suffer(const Effects& effects) {
  effects_ = effects;
  for (const auto& servo : servos_) servo->suffer(effects);
  if (imu_) imu_->silence(effects.imu_silent);
  update_drive();
}

void DynamixelBoard::update_drive() {
  for (const auto& servo : servos_) {
    drive_.powered.set(servo->joint(), servo->torque_is_on());
    drive_.target_rad[servo->joint()] = servo->target_rad();
  }
}

}  // namespace scarab::emulator
