#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/robot/robot_model.hpp"
#include "services/robot_bridge/core/calibration.hpp"
#include "services/robot_bridge/drivers/dynamixel/config.hpp"
#include "tools/emulator/boards/board.hpp"
#include "tools/emulator/boards/dynamixel/device_bus.hpp"
#include "tools/emulator/boards/dynamixel/sensor_board.hpp"
#include "tools/emulator/boards/dynamixel/servo.hpp"

namespace scarab::emulator {

/// DYNAMIXEL servos on one bus, with the boards for IMU and feet that the configuration names.
class DynamixelBoard final : public Board {
 public:
  /// Throws std::invalid_argument naming the joint if one of the robot's has no servo or no
  /// calibration.
  DynamixelBoard(const dxl::Config& config, const robot::RobotModel& robot,
                 const bridge::Calibration& calibration, Note note);

  [[nodiscard]] std::string description() const override;
  [[nodiscard]] unsigned baud() const override { return config_.baud; }
  void on_byte(std::uint8_t byte, std::int64_t now_ns, std::vector<Reply>& replies) override;
  void tick(std::int64_t now_ns) override;
  [[nodiscard]] std::int64_t next_tick_ns() const override;
  void sense(const plant::Observation& body) override;
  void suffer(const Effects& effects) override;
  [[nodiscard]] const Drive& drive() const override { return drive_; }
  [[nodiscard]] std::uint64_t power_ups() const override;
  void put_back() override {}

 private:
  void add_servos(const robot::RobotModel& robot, const bridge::Calibration& calibration);
  void add_sensor_boards();
  void update_drive();

  dxl::Config config_;
  Note note_;
  std::vector<std::unique_ptr<Servo>> servos_;
  std::optional<SensorBoard> imu_;
  std::optional<SensorBoard> feet_;
  DeviceBus bus_;
  Effects effects_;
  Drive drive_;
};

}  // namespace scarab::emulator
