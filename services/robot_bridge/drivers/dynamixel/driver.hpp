#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "services/robot_bridge/core/driver.hpp"
#include "services/robot_bridge/drivers/dynamixel/bus.hpp"
#include "services/robot_bridge/drivers/dynamixel/config.hpp"
#include "services/robot_bridge/drivers/dynamixel/servo_group.hpp"
#include "services/robot_bridge/drivers/dynamixel/servo_health.hpp"
#include "services/robot_bridge/drivers/dynamixel/setup.hpp"

namespace scarab::bridge::dynamixel {

/// A robot of DYNAMIXEL servos on one bus.
class DynamixelDriver final : public Driver {
 public:
  /// `servos` as servos_of() makes them.
  DynamixelDriver(const Config& config, std::string port, std::vector<Servo> servos);
  ~DynamixelDriver() override;

  void open() override;
  void close() noexcept override;
  Readings read() override;
  void activate(const robot::JointVector& hold_rad) override;
  void write(const robot::JointVector& target_rad) override;
  bool hold() noexcept override;
  bool release() noexcept override;
  [[nodiscard]] Capabilities capabilities() const override;
  [[nodiscard]] std::vector<std::pair<std::string, std::uint64_t>> counters() const override;
  [[nodiscard]] std::optional<CrashFrame> crash_frame() const override;

 private:
  [[nodiscard]] Counts goals_for(const robot::JointVector& target_rad);
  void check_reach(const Counts& goals, const robot::JointVector& hold_rad) const;
  void check_watchdog();
  void stop_where_they_are();

  Config config_;
  Bus bus_;
  ServoGroup servos_;
  std::int64_t watchdog_counts_;
  double watchdog_s_;                  ///< what those counts mean
  std::vector<ServoLimits> limits_;    ///< since open()
  std::optional<ServoHealth> health_;  ///< since open()
  Counts positions_;                   ///< measured last
  Counts goals_;                       ///< written last
  bool powered_ = false;               ///< torque may be on
  std::uint64_t goals_limited_ = 0;
  std::uint64_t opened_ = 0;
};

}  // namespace scarab::bridge::dynamixel
