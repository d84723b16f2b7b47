#pragma once

#include <string>
#include <string_view>

#include "services/robot_bridge/core/calibration.hpp"

namespace scarab::bridge::calibrate {

/// The text of a calibration file with another entry for one joint, `note` behind it as a comment;
/// everything else, comments too, stays as it is. An entry that is not there is added at the end.
[[nodiscard]] std::string with_entry(const std::string& text, std::string_view joint,
                                     const JointCalibration& c, std::string_view note);

/// A file that begins: every joint slot `absent`.
[[nodiscard]] std::string empty_calibration_text();

}  // namespace scarab::bridge::calibrate
