#include "services/robot_bridge/drivers/amosii/driver.hpp"

#include <chrono>
#include <stdexcept>
#include <string_view>

#include "services/robot_bridge/drivers/amosii/sensors.hpp"

namespace scarab::bridge::amosii {
namespace {

serial::Clock::duration duration_of(double time_s) {
  return std::chrono::duration_cast<serial::Clock::duration>(std::chrono::duration<double>(time_s));
}

Manners manners_of(const Config& config) {
  return {duration_of(config.reply_timeout_s), config.attempts, duration_of(config.pause_s)};
}

}  // namespace

AmosiiDriver::AmosiiDriver(Config config, const robot::RobotModel& robot,
                           const Calibration& calibration)
    : config_(std::move(config)) {
  for (std::size_t joint = 0; joint < robot::kJointCount; ++joint) {
    if (!robot.joints[joint].present) continue;
    if (!calibration.joints[joint]) {
      throw std::invalid_argument("joint " + std::string(robot::kJointNames[joint]) +
                                  " has no calibration");
    }
    joints_[joint] = calibration.joints[joint];
  }
}

Board& AmosiiDriver::board() {
  if (!board_) throw DeviceError(config_.port + ": not open");
  return *board_;
}

void AmosiiDriver::open() {
  board_.emplace(config_.port, manners_of(config_), counters_);
  try {
    (void)board_->get();
  } catch (...) {
    board_.reset();
    throw;
  }
}

void AmosiiDriver::close() noexcept { board_.reset(); }

Readings AmosiiDriver::read() {
  Readings readings;
  add_sensors(config_, board().get(), readings);
  if (!commanded_rad_) return readings;
  for (std::size_t joint = 0; joint < robot::kJointCount; ++joint) {
    if (!joints_[joint]) continue;
    readings.position_rad.value[joint] = (*commanded_rad_)[joint];
    readings.position_rad.source[joint] = Source::kCommanded;
  }
  return readings;
}

void AmosiiDriver::activate(const robot::JointVector& hold_rad) { write(hold_rad); }

void AmosiiDriver::write(const robot::JointVector& target_rad) {
  Slots motors = all_slots(kMiddle);
  robot::JointVector commanded{};
  for (std::size_t joint = 0; joint < robot::kJointCount; ++joint) {
    if (!joints_[joint]) continue;
    const double m = motor_command_for(*joints_[joint], target_rad[joint]);
    motors[kMotorSlots[joint].slot] = motor_byte(joint, m);
    commanded[joint] = joint_angle_for(*joints_[joint], effective_command(joint, m));
  }
  board().set(motors);
  commanded_rad_ = commanded;
}

bool AmosiiDriver::hold() noexcept { return board_.has_value(); }

bool AmosiiDriver::release() noexcept { return false; }

Capabilities AmosiiDriver::capabilities() const {
  Capabilities able;
  able.foot_force = true;
  able.imu = config_.inclinometer.has_value();
  able.supply_current = true;
  able.link = config_.port + " at " + std::to_string(kBaud) + " baud";
  return able;
}

std::vector<std::pair<std::string, std::uint64_t>> AmosiiDriver::counters() const {
  return {{"amosii_sets", counters_.sets},
          {"amosii_gets", counters_.gets},
          {"amosii_replies", counters_.replies},
          {"amosii_replies_damaged", counters_.replies_damaged},
          {"amosii_replies_missing", counters_.replies_missing}};
}

std::optional<CrashFrame> AmosiiDriver::crash_frame() const { return std::nullopt; }

std::unique_ptr<Driver> make(const Config& config, const robot::RobotModel& robot,
                             const Calibration& calibration, const std::string& device_override) {
  Config used = config;
  if (!device_override.empty()) used.port = device_override;
  return std::make_unique<AmosiiDriver>(used, robot, calibration);
}

}  // namespace scarab::bridge::amosii
