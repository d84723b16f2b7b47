#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "services/robot_bridge/core/lifecycle.hpp"
#include "services/robot_bridge/core/limits.hpp"
#include "services/robot_bridge/core/start_pose.hpp"
#include "services/robot_bridge/drivers/registry.hpp"

namespace scarab::bridge {

/// One of kDriverNames, by its place there.
enum class DriverName : std::size_t {};

[[nodiscard]] constexpr std::size_t index_of(DriverName name) {
  return static_cast<std::size_t>(name);
}

/// The control period is a whole multiple of the sensor period.
struct TimingConfig {
  double control_period_s = 0.1;
  double sensor_period_s = 0.02;
};

[[nodiscard]] unsigned samples_per_tick(const TimingConfig& timing);

/// config/robot_bridge/*.yaml.
struct BridgeConfig {
  DriverName driver{};
  TimingConfig timing;
  StartPose start;
  double homing_velocity_rad_s = 0.5;
  SafeStop safe_stop = SafeStop::kHold;
  LimitsConfig limits;
  std::string calibration;  ///< path; absolute once the file has been read
  DriverSections sections;  ///< that of `driver` is there
};

/// Reads config/robot_bridge/*.yaml; a calibration file is named relative to this one. Throws
/// config::Error (`file:line:col: key: reason`), also if there is no calibration file.
[[nodiscard]] BridgeConfig load_config(const std::filesystem::path& path);

/// The same from text, with the calibration's path as it is there; errors name it `file`.
[[nodiscard]] BridgeConfig load_config_text(const std::string& file, const std::string& text);

/// YAML that load_config reads back to an equal value.
[[nodiscard]] std::string dump_config(const BridgeConfig& config);

/// JSON Schema of the files that load_config reads (config/schema/robot_bridge.json).
[[nodiscard]] std::string config_schema();

}  // namespace scarab::bridge
