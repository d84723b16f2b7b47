#include "tools/emulator/boards/dynamixel/servo_table.hpp"

namespace scarab::emulator {
namespace {

/// Values and ranges: e-Manual, XM430-W350, "Control Table" (column "Initial Value") and "Control
/// Table Description".
constexpr std::int64_t kBaudRateMost = 7;
constexpr std::int64_t kReturnDelay = 250;
constexpr std::int64_t kReturnDelayMost = 254;
constexpr std::int64_t kTemperatureLimit = 80;
constexpr std::int64_t kTemperatureMost = 100;
constexpr std::int64_t kCurrentLimit = 1193;
constexpr std::int64_t kPositionMost = 4095;
constexpr std::int64_t kShutdownBits = 0x34;  // overload, electrical shock, overheating
constexpr std::int64_t kShutdownMost = 0x3D;
constexpr std::int64_t kVoltage = 120;  // 12.0 V

void add_general(ControlTable& table, const dxl::ServoModel& m, std::uint8_t id) {
  using namespace servo_items;
  table.add({kModelNumber, Access::kRead, m.model_number});
  table.add({kFirmware, Access::kRead, kServoFirmware});
  table.add({kId, Access::kEeprom, id, 0, dxl::kMaxId});
  table.add({kBaudRate, Access::kEeprom, 1, 0, kBaudRateMost});
  table.add({kShutdown, Access::kEeprom, kShutdownBits, 0, kShutdownMost});
  table.add({kLed, Access::kRam, 0, 0, 1});
  table.add({kMoving, Access::kRead});
}

void add_settings(ControlTable& table, const dxl::ServoModel& m) {
  table.add({m.return_delay, Access::kEeprom, kReturnDelay, 0, kReturnDelayMost});
  table.add({m.drive_mode, Access::kEeprom, 0, 0, 0});
  table.add({m.operating_mode, Access::kEeprom, dxl::kPositionControlMode,
             dxl::kPositionControlMode, dxl::kPositionControlMode});
  table.add({m.temperature_limit, Access::kEeprom, kTemperatureLimit, 0, kTemperatureMost});
  table.add({m.current_limit, Access::kEeprom, kCurrentLimit, 0, kCurrentLimit});
  table.add({m.max_position_limit, Access::kEeprom, kPositionMost, 0, kPositionMost});
  table.add({m.min_position_limit, Access::kEeprom, 0, 0, kPositionMost});
}

void add_state(ControlTable& table, const dxl::ServoModel& m) {
  table.add({m.torque_enable, Access::kRam, 0, 0, 1});
  table.add(
      {m.status_return_level, Access::kRam, dxl::kReturnAllStatuses, 0, dxl::kReturnAllStatuses});
  table.add({m.hardware_error_status, Access::kRead});
  table.add({m.bus_watchdog, Access::kRam, 0, 0, dxl::kMaxBusWatchdog});
  table.add({m.goal_position, Access::kRam, m.centre_ticks, 0, kPositionMost});
  table.add({m.present_current, Access::kRead});
  table.add({m.present_velocity, Access::kRead});
  table.add({m.present_position, Access::kRead, m.centre_ticks});
  table.add({m.present_voltage, Access::kRead, kVoltage});
  table.add({m.present_temperature, Access::kRead, kServoTemperatureC});
}

}  // namespace

ControlTable servo_table(const dxl::ServoModel& model, std::uint8_t id) {
  ControlTable table;
  add_general(table, model, id);
  add_settings(table, model);
  add_state(table, model);
  return table;
}

}  // namespace scarab::emulator
