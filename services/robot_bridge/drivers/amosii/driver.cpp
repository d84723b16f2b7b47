#include "services/robot_bridge/drivers/amosii/driver.hpp"

#include <chrono>

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
    : config_(std::move(config)), calibration_(of_robot(calibration, robot)) {}

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
    if (!calibration_.joints[joint]) continue;
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
    if (!calibration_.joints[joint]) continue;
    const double m = motor_command_for(*calibration_.joints[joint], target_rad[joint]);
    motors[kMotorSlots[joint].slot] = motor_byte(joint, m);
    commanded[joint] = joint_angle_for(*calibration_.joints[joint], effective_command(joint, m));
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

std::unique_ptr<Driver> make(const Config& config, const robot::RobotModel& robot,
                             const Calibration& calibration, const std::string& device_override) {
  Config used = config;
  if (!device_override.empty()) used.port = device_override;
  return std::make_unique<AmosiiDriver>(used, robot, calibration);
}

}  // namespace scarab::bridge::amosii
