#pragma once

#include <filesystem>
#include <string>

#include "common/robot/robot_model.hpp"

namespace scarab::config {

/// Reads a robot file (config/robot/*.yaml). Angles in rad, signs as in common/robot/joints.hpp. A
/// joint given as `absent` is marked so in its slot, left and right. Throws Error (`file:line:col:
/// key: reason`).
[[nodiscard]] robot::RobotModel load_robot(const std::filesystem::path& path);

/// The same from text; errors name it `file`.
[[nodiscard]] robot::RobotModel load_robot_text(const std::string& file, const std::string& text);

/// A robot file that load_robot() reads back to an equal model. Throws std::invalid_argument if the
/// left and the right joints of a row differ, which a robot file cannot say.
[[nodiscard]] std::string dump_robot(const robot::RobotModel& model);

}  // namespace scarab::config
