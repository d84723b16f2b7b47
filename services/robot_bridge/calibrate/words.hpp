#pragma once

#include <cstddef>
#include <string>

namespace scarab::bridge::calibrate {

/// "+0.35 rad (20.1 deg)"
[[nodiscard]] std::string angle_words(double rad);

/// How the joint looks at an angle: "straight out sideways" at 0, else the angle.
[[nodiscard]] std::string pose_words(std::size_t joint, double joint_rad);

/// Which way the joint's angle grows: "forwards", "upwards" ...
[[nodiscard]] std::string positive_words(std::size_t joint);

}  // namespace scarab::bridge::calibrate
