#include "services/robot_bridge/drivers/dynamixel/driver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "services/robot_bridge/drivers/dynamixel/boards.hpp"
#include "services/robot_bridge/drivers/dynamixel/feedback.hpp"
#include "services/robot_bridge/drivers/dynamixel/torque.hpp"

namespace scarab::bridge::dynamixel {
namespace {

/// A joint may stand so far outside of its servo's goals and still be switched on.
constexpr double kMaxStepOnActivation_rad = 0.1;
/// A joint that lags its goal by more is stopped where it is; else its goal stays: a goal that was
/// set to where a loaded joint stands would let it sink.
constexpr double kLagWhileHolding_rad = 0.05;

constexpr int kOffFrames = 3;  // sent blindly when nobody confirms

BusOptions bus_options(const Config& config, const std::string& port,
                       const std::vector<Servo>& servos) {
  BusOptions options{port, config.baud, config.reply_timeout_s, config.retries, {}};
  for (const Servo& servo : servos) options.names[servo.id] = name_of(servo);
  if (config.imu) options.names[config.imu->id] = "the IMU board";
  if (config.foot_force) options.names[config.foot_force->id] = "the foot force board";
  return options;
}

/// Seconds in the servos' count, not less than asked for.
std::int64_t watchdog_counts(double watchdog_s, const Item& item) {
  const auto counts = static_cast<std::int64_t>(std::ceil(watchdog_s / item.unit - 1e-9));
  return std::clamp<std::int64_t>(counts, 1, kMaxBusWatchdog);
}

}  // namespace

DynamixelDriver::DynamixelDriver(const Config& config, std::string port, std::vector<Servo> servos)
    : config_(config),
      bus_(bus_options(config, port, servos)),
      servos_(bus_, std::move(servos), config.sync_read),
      watchdog_counts_(
          watchdog_counts(config.bus_watchdog_s, servos_.servos().front().model.bus_watchdog)),
      watchdog_s_(static_cast<double>(watchdog_counts_) *
                  servos_.servos().front().model.bus_watchdog.unit) {}

DynamixelDriver::~DynamixelDriver() {
  if (powered_ && bus_.is_open()) release();
}

void DynamixelDriver::open() {
  close();
  try {
    bus_.open();
    find_devices(servos_, boards_of(config_));
    prepare(servos_);
    limits_ = read_limits(servos_);
    health_.emplace(limits_);
    positions_ = servos_.read(&ServoModel::present_position);
    ++opened_;
  } catch (...) {
    close();
    throw;
  }
}

void DynamixelDriver::close() noexcept {
  powered_ = false;
  bus_.close();
}

Readings DynamixelDriver::read() {
  check_watchdog();
  Readings readings;
  const std::vector<Status> answers = servos_.read(feedback_region(servos_));
  decode_feedback(servos_, answers, readings);
  positions_ = positions_in(servos_, answers);
  if (config_.imu) read_board(bus_, *config_.imu, readings);
  if (config_.foot_force) read_board(bus_, *config_.foot_force, readings);
  health_.value().look(servos_, answers, powered_);
  health_->report(servos_, readings);
  return readings;
}

void DynamixelDriver::activate(const robot::JointVector& hold_rad) {
  if (!bus_.is_open()) throw DeviceError(bus_.path() + " is not open");
  const Counts goals = goals_for(hold_rad);
  check_reach(goals, hold_rad);
  goals_ = goals;
  powered_ = true;  // from here on some may be
  switch_on(servos_, goals, watchdog_counts_);
}

void DynamixelDriver::write(const robot::JointVector& target_rad) {
  if (!powered_) throw DeviceError(bus_.path() + ": goals for motors that are off");
  check_watchdog();
  const Counts goals = goals_for(target_rad);
  servos_.write(&ServoModel::goal_position, goals);
  goals_ = goals;
}

bool DynamixelDriver::hold() noexcept {
  if (!powered_) return true;
  try {
    stop_where_they_are();
    return servos_.read(&ServoModel::goal_position) == goals_;
  } catch (const std::exception&) {
    return false;
  }
}

bool DynamixelDriver::release() noexcept {
  try {
    switch_off(servos_);
    powered_ = false;
    return true;
  } catch (const std::exception&) {
    // One that is silent must not keep the others from hearing it.
  }
  try {
    const Counts off(servos_.size(), 0);
    for (int i = 0; i < kOffFrames; ++i) servos_.write(&ServoModel::torque_enable, off);
  } catch (const std::exception&) {
    // The port is gone: their own time-out stops them.
  }
  return false;
}

Capabilities DynamixelDriver::capabilities() const {
  Capabilities c;
  c.position_feedback = c.velocity_feedback = c.torque_feedback = true;
  c.foot_force = config_.foot_force.has_value();
  c.imu = config_.imu.has_value();
  c.temperature = c.joint_current = c.supply_current = c.torque_switch = true;
  c.device_timeout_s = watchdog_s_;
  c.link = bus_.path() + " at " + std::to_string(config_.baud) + " baud";
  return c;
}

std::vector<std::pair<std::string, std::uint64_t>> DynamixelDriver::counters() const {
  const BusCounters& bus = bus_.counters();
  const ParserCounters& parser = bus_.parser_counters();
  return {{"bus_exchanges", bus.exchanges},
          {"bus_retries", bus.retries},
          {"bus_timeouts", bus.timeouts},
          {"bus_wrong_answers", bus.wrong_answers},
          {"bus_refusals", bus.refusals},
          {"bus_bytes_received", bus.bytes_received},
          {"bus_bytes_dropped", parser.bytes_dropped + bus.bytes_late},
          {"bus_crc_errors", parser.crc_errors},
          {"bus_frame_errors", parser.length_errors + parser.stuffing_errors + parser.cut_short},
          {"goals_limited", goals_limited_},
          {"device_opened", opened_}};
}

std::optional<CrashFrame> DynamixelDriver::crash_frame() const {
  if (!bus_.is_open()) return std::nullopt;
  // Whoever writes it cannot wait for the line: one may meet an answer that is under way.
  CrashFrame frame{bus_.fd(), {}};
  const Bytes once = switch_off_frame(servos_);
  for (int i = 0; i < kOffFrames; ++i) {
    frame.bytes.insert(frame.bytes.end(), once.begin(), once.end());
  }
  return frame;
}

/// Ended at what the servo takes: it would refuse more, and nobody would hear of it.
Counts DynamixelDriver::goals_for(const robot::JointVector& target_rad) {
  Counts goals;
  for (std::size_t i = 0; i < servos_.size(); ++i) {
    const Servo& servo = servos_.servos()[i];
    const std::int64_t wanted = goal_ticks(servo, target_rad[servo.joint]);
    goals.push_back(std::clamp(wanted, limits_[i].min_ticks, limits_[i].max_ticks));
    if (goals.back() != wanted) ++goals_limited_;
  }
  return goals;
}

void DynamixelDriver::check_reach(const Counts& goals, const robot::JointVector& hold_rad) const {
  for (std::size_t i = 0; i < servos_.size(); ++i) {
    const Servo& servo = servos_.servos()[i];
    const double step_rad = std::abs(joint_rad(servo, goals[i]) - hold_rad[servo.joint]);
    if (step_rad <= kMaxStepOnActivation_rad) continue;
    throw DeviceError(fmt::format(
        "{}: {} stands at {:.2f} rad, {:.2f} rad beyond its range; bring it into it by hand",
        bus_.path(), servos_.name_of(i), hold_rad[servo.joint], step_rad));
  }
}

/// Devices that have heard nothing for so long that they have stopped by themselves take no goals
/// any more, and do not say so.
void DynamixelDriver::check_watchdog() {
  const double silent_s =
      std::chrono::duration<double>(serial::Clock::now() - bus_.told_at()).count();
  if (!powered_ || silent_s < watchdog_s_) return;
  const Counts states = servos_.read(&ServoModel::bus_watchdog);
  for (std::size_t i = 0; i < servos_.size(); ++i) {
    if (states[i] != kBusWatchdogTripped) continue;
    throw DeviceError(
        fmt::format("{}: nothing was sent for {:.2f} s, and the bus watchdog of {} has stopped it",
                    bus_.path(), silent_s, servos_.name_of(i)));
  }
}

/// Tells it without asking first: that would take time.
void DynamixelDriver::stop_where_they_are() {
  Counts goals = goals_;
  for (std::size_t i = 0; i < servos_.size(); ++i) {
    const double lag_rad = std::abs(static_cast<double>(goals[i] - positions_[i]) *
                                    servos_.servos()[i].model.present_position.unit);
    if (lag_rad <= kLagWhileHolding_rad) continue;
    goals[i] = std::clamp(positions_[i], limits_[i].min_ticks, limits_[i].max_ticks);
  }
  servos_.write(&ServoModel::goal_position, goals);
  goals_ = goals;
}

std::unique_ptr<Driver> make(const Config& config, const robot::RobotModel& robot,
                             const Calibration& calibration, const std::string& device_override) {
  return std::make_unique<DynamixelDriver>(config,
                                           device_override.empty() ? config.port : device_override,
                                           servos_of(config, robot, calibration));
}

}  // namespace scarab::bridge::dynamixel
