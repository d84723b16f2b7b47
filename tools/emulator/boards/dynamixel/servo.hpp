#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "services/robot_bridge/core/calibration.hpp"
#include "tools/emulator/boards/board.hpp"
#include "tools/emulator/boards/dynamixel/device.hpp"
#include "tools/emulator/boards/dynamixel/servo_table.hpp"

namespace scarab::emulator {

/// Where a servo sits.
struct ServoPlace {
  std::size_t joint = 0;  ///< slot
  std::uint8_t id = 0;
  bridge::JointCalibration calibration;
};

/// What the joint behind a servo does.
struct JointMotion {
  double position_rad = 0;
  double velocity_rad_s = 0;
  double torque_nm = 0;
};

/// One DYNAMIXEL servo in position control: its control table, and what it makes of it.
///
/// Bus watchdog (e-Manual, "Bus Watchdog"): while the torque is on, a bus without an instruction
/// for its time stops the servo where it is, sets the watchdog to -1, and goals are refused (data
/// range error) until it is written 0.
/// Shutdown (e-Manual, "Shutdown"): hotter than the temperature limit it reports overheating, sets
/// the alert bit of each status and takes its torque off, until a reboot.
class Servo final : public Device {
 public:
  Servo(const dxl::ServoModel& model, const ServoPlace& place, Note note);

  [[nodiscard]] std::uint8_t id() const override { return place_.id; }
  [[nodiscard]] bool is_awake(std::int64_t now_ns) const override;
  [[nodiscard]] dxl::PingAnswer ping() const override;
  [[nodiscard]] dxl::Status read(dxl::Region region) const override;
  dxl::StatusError write(std::uint16_t address, dxl::ByteView data) override;
  void reboot(std::int64_t now_ns) override;
  void hear(std::int64_t now_ns) override;
  [[nodiscard]] dxl::Status status(dxl::StatusError error) const override;
  [[nodiscard]] std::int64_t status_return_level() const override;
  [[nodiscard]] std::int64_t return_delay_ns() const override;

  void tick(std::int64_t now_ns);
  /// When the watchdog would bark; none: it does not watch.
  [[nodiscard]] std::optional<std::int64_t> watchdog_ns() const;

  void sense(const JointMotion& joint);
  void suffer(const Effects& effects);

  [[nodiscard]] std::size_t joint() const { return place_.joint; }
  [[nodiscard]] bool torque_is_on() const { return table_.get(model_.torque_enable) != 0; }
  [[nodiscard]] double target_rad() const { return target_rad_; }
  [[nodiscard]] std::uint64_t power_ups() const { return power_ups_; }

 private:
  [[nodiscard]] dxl::StatusError check(std::uint16_t address, dxl::ByteView data) const;
  [[nodiscard]] bool covers(const dxl::Item& item, std::uint16_t address, dxl::ByteView data) const;
  [[nodiscard]] double joint_rad(std::int64_t ticks) const;
  void follow_goal();
  void set_torque(bool on);
  void show_current();
  void warm();
  [[nodiscard]] std::string name() const;

  dxl::ServoModel model_;
  ServoPlace place_;
  Note note_;
  ControlTable table_;
  JointMotion motion_;
  double extra_current_a_ = 0;
  std::optional<double> heat_c_;
  bool is_silent_ = false;
  double target_rad_ = 0;  // of the joint
  std::int64_t heard_ns_ = 0;
  std::int64_t awake_from_ns_ = 0;
  std::uint64_t power_ups_ = 0;
};

}  // namespace scarab::emulator
