#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "services/robot_bridge/drivers/loopback/config.hpp"
#include "services/robot_bridge/drivers/loopback/servos.hpp"

namespace scarab::bridge::loopback {

class LoopbackDriver : public Driver {
 public:
  LoopbackDriver(Config config, const robot::RobotModel& robot, const Calibration& calibration);

  void open() override;
  void close() noexcept override;
  Readings read() override;
  void activate(const robot::JointVector& hold_rad) override;
  void write(const robot::JointVector& target_rad) override;
  bool hold() noexcept override;
  bool release() noexcept override;
  [[nodiscard]] Capabilities capabilities() const override;
  [[nodiscard]] std::vector<std::pair<std::string, std::uint64_t>> counters() const override;

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] bool is_on(const Fault& fault) const;
  [[nodiscard]] bool is_on(FaultKind kind) const;
  /// The servos move on to the present.
  void advance();
  /// The same; throws DeviceError if the device is not there.
  void catch_up();
  void add_joints(Readings& readings) const;
  void add_faults(Readings& readings) const;

  Config config_;
  Calibration calibration_;  ///< of the robot's own joints
  Servos servos_;
  Clock::time_point made_ = Clock::now();
  Clock::time_point advanced_ = Clock::now();
  std::optional<Clock::time_point> first_active_;
  bool open_ = false;
  std::uint64_t reads_ = 0;
  std::uint64_t writes_ = 0;
};

}  // namespace scarab::bridge::loopback
