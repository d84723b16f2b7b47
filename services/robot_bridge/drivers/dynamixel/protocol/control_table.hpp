#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "services/robot_bridge/drivers/dynamixel/protocol/bytes.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/instructions.hpp"

namespace scarab::bridge::dynamixel {

/// How a value lies in a control table.
enum class Type { kU8, kI8, kU16, kI16, kU32, kI32, kF32 };

[[nodiscard]] constexpr std::size_t size_of(Type type) {
  switch (type) {
    case Type::kU8:
    case Type::kI8:
      return 1;
    case Type::kU16:
    case Type::kI16:
      return 2;
    case Type::kU32:
    case Type::kI32:
    case Type::kF32:
      break;
  }
  return 4;
}

/// One value of a control table.
struct Item {
  std::uint16_t address = 0;
  Type type = Type::kU8;
  double unit = 1;  ///< what one count is: SI units, degrees Celsius; 1 for plain numbers

  [[nodiscard]] constexpr std::size_t size() const { return size_of(type); }
  [[nodiscard]] constexpr Region region() const {
    return {address, static_cast<std::uint16_t>(size())};
  }
};

/// The count in `data`, which has as many bytes as the item, an integer.
[[nodiscard]] std::int64_t count_in(const Item& item, ByteView data);
/// The bytes of a count of an integer item; high bits that do not fit are lost.
[[nodiscard]] Bytes bytes_of(const Item& item, std::int64_t count);

/// The value in `data`, which has as many bytes as the item: count * unit.
[[nodiscard]] double value_in(const Item& item, ByteView data);
/// The bytes of the nearest value that the item can hold.
[[nodiscard]] Bytes bytes_of_value(const Item& item, double value);

/// The smallest region with both in it.
[[nodiscard]] Region hull(Region a, Region b);

/// What a kind of servo is: where its values stand, and what they mean. The defaults are an
/// XM430-W350's (ROBOTIS e-Manual, XM430-W350, "Control Table of EEPROM Area" and "of RAM Area").
struct ServoModel {
  std::uint16_t model_number = 1020;

  /// Joint torque per current. XM430-W350: 4.1 N m at 2.3 A, its stall figures at 12 V (e-Manual,
  /// "Specifications"). A reconstruction: the manual gives no torque constant, and gears lose more
  /// at less load.
  double torque_constant_nm_a = 4.1 / 2.3;
  /// The middle of the servo's scale: its angle of 0 ("Goal Position": 0 to 4095 a turn).
  std::int32_t centre_ticks = 2048;

  Item return_delay{9, Type::kU8, 2e-6};
  Item drive_mode{10, Type::kU8, 1};
  Item operating_mode{11, Type::kU8, 1};
  Item temperature_limit{31, Type::kU8, 1};
  Item current_limit{38, Type::kU16, 2.69e-3};
  Item max_position_limit{48, Type::kU32, kRadPerTick};
  Item min_position_limit{52, Type::kU32, kRadPerTick};
  Item torque_enable{64, Type::kU8, 1};
  Item status_return_level{68, Type::kU8, 1};
  Item hardware_error_status{70, Type::kU8, 1};
  Item bus_watchdog{98, Type::kI8, 0.020};
  Item goal_position{116, Type::kI32, kRadPerTick};
  Item present_current{126, Type::kI16, 2.69e-3};
  Item present_velocity{128, Type::kI32, 0.229 * kRadPerSPerRpm};
  Item present_position{132, Type::kI32, kRadPerTick};
  Item present_voltage{144, Type::kU16, 0.1};
  Item present_temperature{146, Type::kU8, 1};

 private:
  static constexpr double kPi = 3.14159265358979323846;
  static constexpr double kRadPerTick = 2 * kPi / 4096;
  static constexpr double kRadPerSPerRpm = 2 * kPi / 60;
};

/// Calls f(name, item) for each item of a model, const or not.
template <class Model, class F>
void for_each_item(Model& m, F&& f) {
  f("return_delay", m.return_delay);
  f("drive_mode", m.drive_mode);
  f("operating_mode", m.operating_mode);
  f("temperature_limit", m.temperature_limit);
  f("current_limit", m.current_limit);
  f("max_position_limit", m.max_position_limit);
  f("min_position_limit", m.min_position_limit);
  f("torque_enable", m.torque_enable);
  f("status_return_level", m.status_return_level);
  f("hardware_error_status", m.hardware_error_status);
  f("bus_watchdog", m.bus_watchdog);
  f("goal_position", m.goal_position);
  f("present_current", m.present_current);
  f("present_velocity", m.present_velocity);
  f("present_position", m.present_position);
  f("present_voltage", m.present_voltage);
  f("present_temperature", m.present_temperature);
}

/// The name by which configurations call the built-in model.
inline constexpr std::string_view kBuiltInModel = "xm430-w350";

/// Values that items take (e-Manual, XM430-W350, "Control Table Description").
inline constexpr std::int64_t kPositionControlMode = 3;   ///< operating_mode
inline constexpr std::int64_t kReturnAllStatuses = 2;     ///< status_return_level
inline constexpr std::int64_t kMaxBusWatchdog = 127;      ///< bus_watchdog, in its unit
inline constexpr std::int64_t kBusWatchdogTripped = -1;   ///< bus_watchdog: goals are read-only
inline constexpr std::int64_t kReverseDriveMode = 0x01;   ///< bit of drive_mode: turns other way
inline constexpr std::uint8_t kInputVoltageError = 0x01;  ///< bits of hardware_error_status
inline constexpr std::uint8_t kOverheatingError = 0x04;
inline constexpr std::uint8_t kEncoderError = 0x08;
inline constexpr std::uint8_t kElectricalShockError = 0x10;
inline constexpr std::uint8_t kOverloadError = 0x20;

/// The bits of a hardware error status in words, "overheating, overload"; empty for 0.
[[nodiscard]] std::string hardware_error_text(std::uint8_t bits);

}  // namespace scarab::bridge::dynamixel
