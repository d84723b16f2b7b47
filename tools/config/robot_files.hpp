#pragma once

#include <filesystem>
#include <optional>

namespace scarab::config_tool {

/// Files that are to work together, as far as they were given.
struct RobotFiles {
  std::optional<std::filesystem::path> robot;
  std::optional<std::filesystem::path> plant;
  std::optional<std::filesystem::path> premotor;
  std::optional<std::filesystem::path> supervisor;
  std::optional<std::filesystem::path> robot_bridge;
  std::optional<std::filesystem::path> calibration;
};

/// Reads the files and looks at what no single one of them can tell: angles at which a joint is
/// told to stand are within its range, beyond which the programs would clip them in silence; the
/// supervisor compares the front legs with the angle that the premotor controller tells them to
/// hold; servos reach what the robot is described with; and a robot behind its bridge starts, and
/// is asked, as the plant is. Throws config::Error at the first value that does not fit.
void expect_match(const RobotFiles& files);

}  // namespace scarab::config_tool
