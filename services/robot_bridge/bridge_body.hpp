#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "common/runtime/histogram.hpp"
#include "common/runtime/tick_body.hpp"
#include "services/robot_bridge/config.hpp"
#include "services/robot_bridge/core/guarded_device.hpp"
#include "services/robot_bridge/referee_reader.hpp"

namespace scarab::bridge {

/// A real robot as the tick master moves it.
///
/// Time is nominal: what the ticks and samples since start() add up to, whatever the wall clock
/// says of each of them.
class BridgeBody : public runtime::TickBody {
 public:
  /// Its end switches the motors off and closes the device.
  BridgeBody(bus::Participant& participant, std::unique_ptr<Driver> driver,
             const BridgeConfig& config);

  void begin(const scarab_Trial& trial) override;
  [[nodiscard]] bool configured() const override;
  [[nodiscard]] std::string waiting_for() const override;
  void activate() override;
  [[nodiscard]] robot::JointVector held_rad() const override;
  [[nodiscard]] robot::JointVector home_rad() const override { return home_rad_; }
  void start() override;
  [[nodiscard]] std::int64_t time_ns() const override { return time_ns_; }
  void observe(scarab_RobotState& state) override;
  void advance(const robot::JointVector& target_rad, const std::function<void()>& sample) override;
  [[nodiscard]] std::optional<runtime::TrialEnd> verdict() const override { return verdict_; }
  void end(const runtime::TrialEnd& end) override { verdict_ = end; }
  void rest() noexcept override;

  void safe_stop() noexcept override;
  [[nodiscard]] bool powered() const noexcept override;
  [[nodiscard]] std::optional<std::string> fault() const override;

  bool idle() override;

  void publish_own(const scarab_Header&) override {}
  void flush_own() override {}
  void report(runtime::StatusPublisher& status) const override;
  void add_needs(runtime::PeerCheck&) const override {}

 private:
  void look_for_device();
  void exchange();
  void judge();

  std::unique_ptr<Driver> driver_;
  std::string link_;
  bool has_torque_switch_;
  robot::JointVector home_rad_;
  std::int64_t tick_ns_;
  unsigned samples_per_tick_;
  GuardedDevice device_;
  RefereeReader referee_;
  runtime::Histogram bus_exchange_;

  scarab_GoalKind goal_ = scarab_GOAL_NONE;
  double time_limit_s_ = 0;
  bool started_ = false;
  std::int64_t time_ns_ = 0;
  std::optional<runtime::TrialEnd> verdict_;
};

}  // namespace scarab::bridge
