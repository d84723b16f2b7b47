#include "services/robot_bridge/bridge_body.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <cmath>
#include <utility>

#include "services/robot_bridge/adapter.hpp"

namespace scarab::bridge {
namespace {

using Clock = std::chrono::steady_clock;

double now_s() { return std::chrono::duration<double>(Clock::now().time_since_epoch()).count(); }

/// Limits that the device cannot be watched for, as it does not tell.
void warn_of_blind_limits(const LimitsConfig& limits, const Capabilities& device) {
  const auto warn = [](bool blind, const char* what) {
    if (blind) spdlog::warn("no safe stop on {}: the device does not tell it", what);
  };
  warn(limits.temperature_max_c && !device.temperature, "temperature");
  warn(limits.joint_current_max_a && !device.joint_current, "a joint's current");
  warn(limits.supply_current_max_a && !device.supply_current, "the supply current");
  warn(limits.inclination_max_rad && !device.imu, "inclination");
  if (!device.device_timeout_s) {
    spdlog::warn("a bridge that is killed leaves the motors on: the device has no time-out");
  }
}

}  // namespace

BridgeBody::BridgeBody(bus::Participant& participant, std::unique_ptr<Driver> driver,
                       const BridgeConfig& config)
    : driver_(std::move(driver)),
      link_(driver_->capabilities().link),
      has_torque_switch_(driver_->capabilities().torque_switch),
      home_rad_(joint_targets(config.start)),
      tick_ns_(std::llround(config.timing.control_period_s * 1e9)),
      samples_per_tick_(samples_per_tick(config.timing)),
      device_(*driver_, config.safe_stop, config.limits, home_rad_),
      referee_(participant) {
  warn_of_blind_limits(config.limits, driver_->capabilities());
}

void BridgeBody::begin(const scarab_Trial& trial) {
  referee_.begin(trial.header.trial);
  goal_ = trial.goal;
  time_limit_s_ = trial.time_limit_s;
  started_ = false;
  time_ns_ = 0;
  verdict_.reset();
}

bool BridgeBody::configured() const { return device_.present(); }

std::string BridgeBody::waiting_for() const {
  return "the robot at " + link_ + (device_.absence().empty() ? "" : ": " + device_.absence());
}

void BridgeBody::activate() {
  device_.activate();
  spdlog::info("motors on");
}

robot::JointVector BridgeBody::held_rad() const { return device_.held_rad(); }

void BridgeBody::start() { started_ = true; }

void BridgeBody::observe(scarab_RobotState& state) {
  look_for_device();
  exchange();
  fill(state, device_.readings());
}

void BridgeBody::advance(const robot::JointVector& target_rad,
                         const std::function<void()>& sample) {
  device_.apply(target_rad);
  const std::int64_t begun_ns = time_ns_;
  for (unsigned i = 1; i < samples_per_tick_; ++i) {
    if (started_) time_ns_ = begun_ns + i * tick_ns_ / samples_per_tick_;
    judge();
    sample();
  }
  if (started_) time_ns_ = begun_ns + tick_ns_;
  judge();
}

/// As the plant's referee would, as far as a robot without one can tell.
void BridgeBody::judge() {
  if (verdict_) return;
  verdict_ = referee_.verdict();
  const bool over = started_ && time_ns_ >= std::llround(time_limit_s_ * 1e9);
  if (verdict_ || !over) return;
  const bool success = goal_ == scarab_GOAL_NONE;
  verdict_ = {success, fmt::format(success ? "ran to the time limit of {:.1f} s"
                                           : "time limit of {:.1f} s: nobody has seen the goal "
                                             "reached",
                                   time_limit_s_)};
}

void BridgeBody::rest() noexcept {
  const bool were_on = powered();
  device_.rest();
  if (!were_on || !device_.present()) return;
  spdlog::info(has_torque_switch_ ? "motors off"
                                  : "no more goals; the device cannot switch its motors off");
}

void BridgeBody::safe_stop() noexcept { device_.safe_stop(); }

bool BridgeBody::powered() const noexcept { return device_.state() == LifecycleState::kActive; }

std::optional<std::string> BridgeBody::fault() const { return device_.fault(); }

bool BridgeBody::idle() {
  look_for_device();
  return device_.present();
}

void BridgeBody::look_for_device() {
  const bool was_present = device_.present();
  const std::string before = device_.absence();
  device_.look_for(now_s());
  if (!was_present && device_.present()) spdlog::info("robot found at {}", link_);
  if (device_.absence() != before && !device_.present()) {
    spdlog::warn("no robot at {}: {}", link_, device_.absence());
  }
}

void BridgeBody::exchange() {
  if (!device_.present()) return;
  const auto begun = Clock::now();
  device_.exchange();
  if (device_.present()) {
    bus_exchange_.add(Clock::now() - begun);
  } else {
    spdlog::warn("robot lost at {}: {}", link_, device_.absence());
  }
}

void BridgeBody::report(runtime::StatusPublisher& status) const {
  status.set_histogram("bus_exchange", bus_exchange_);
  status.set_counter("device_losses", device_.losses());
  status.set_counter("device_stops_unconfirmed", device_.unconfirmed_stops());
  for (const auto& [name, value] : driver_->counters()) status.set_counter(name, value);
}

}  // namespace scarab::bridge
