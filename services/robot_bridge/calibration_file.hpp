#pragma once

#include <filesystem>
#include <string>

#include "common/robot/robot_model.hpp"
#include "services/robot_bridge/core/calibration.hpp"

/// config/calibration/*.yaml: one entry for each joint slot, by its name, or `absent`.
namespace scarab::bridge {

/// Throws config::Error (`file:line:col: key: reason`).
[[nodiscard]] Calibration load_calibration(const std::filesystem::path& path);

/// The same for a robot, whose every joint must have an entry with which its servo can reach some
/// of the joint's range (within_reach() tells how much). Throws config::Error.
[[nodiscard]] Calibration load_calibration(const std::filesystem::path& path,
                                           const robot::RobotModel& robot);

/// From text; errors name it `file`.
[[nodiscard]] Calibration load_calibration_text(const std::string& file, const std::string& text);

/// YAML that load_calibration reads back to an equal value.
[[nodiscard]] std::string dump_calibration(const Calibration& calibration);

/// JSON Schema of the files that load_calibration reads (config/schema/calibration.json).
[[nodiscard]] std::string calibration_schema();

}  // namespace scarab::bridge
