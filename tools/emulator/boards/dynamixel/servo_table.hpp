#pragma once

#include <cstdint>

#include "services/robot_bridge/drivers/dynamixel/protocol/control_table.hpp"
#include "tools/emulator/boards/dynamixel/control_table.hpp"

namespace scarab::emulator {

/// Items of an XM430-W350 that the bridge has no use for, but its servo does (e-Manual,
/// XM430-W350, "Control Table").
namespace servo_items {
inline constexpr dxl::Item kModelNumber{0, dxl::Type::kU16, 1};
inline constexpr dxl::Item kFirmware{6, dxl::Type::kU8, 1};
inline constexpr dxl::Item kId{7, dxl::Type::kU8, 1};
inline constexpr dxl::Item kBaudRate{8, dxl::Type::kU8, 1};
inline constexpr dxl::Item kShutdown{63, dxl::Type::kU8, 1};
inline constexpr dxl::Item kLed{65, dxl::Type::kU8, 1};
inline constexpr dxl::Item kMoving{122, dxl::Type::kU8, 1};
}  // namespace servo_items

inline constexpr std::uint8_t kServoFirmware = 45;
/// Of a servo that nobody has told to be hot: it does not warm up by its work.
inline constexpr std::int64_t kServoTemperatureC = 30;

/// The control table of a servo at its factory settings: `model`'s items where it has them, around
/// them the rest of what is emulated of an XM430-W350's.
///
/// Less than the real one: the operating mode is position control (3) and nothing else, the drive
/// mode is the normal one (0); gains, profiles, homing offset and indirect addresses are not there.
[[nodiscard]] ControlTable servo_table(const dxl::ServoModel& model, std::uint8_t id);

}  // namespace scarab::emulator
