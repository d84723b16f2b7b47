#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/robot/robot_model.hpp"

namespace scarab::bridge::calibrate {

/// What the person asked for.
struct Request {
  std::filesystem::path robot;
  std::filesystem::path config;
  std::string device;               ///< empty: the configured port
  std::filesystem::path output;     ///< empty: the calibration file that the configuration names
  std::vector<std::string> joints;  ///< empty: all
  std::string pose = "zero";        ///< or "start"
  bool again = false;               ///< joints that have an entry, too
  bool yes = false;                 ///< the present pose is the reference; nobody is asked
  bool check = false;               ///< compare only, write nothing
  double tolerance_rad = 0.1;       ///< of check
};

/// What was asked for cannot be done with this robot or file; what() says why.
class BadRequest : public std::runtime_error {
 public:
  BadRequest(const std::string& option, const std::string& why)
      : std::runtime_error(why), option_(option) {}
  /// Of the command line, such as "--joints".
  [[nodiscard]] const std::string& option() const { return option_; }

 private:
  std::string option_;
};

/// The robot's joints that the request names, in slot order. Throws BadRequest for one that the
/// robot does not have.
[[nodiscard]] std::vector<std::size_t> asked_joints(const Request& request,
                                                    const robot::RobotModel& robot);

}  // namespace scarab::bridge::calibrate
