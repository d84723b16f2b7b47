#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "services/robot_bridge/core/calibration.hpp"

namespace scarab::bridge::calibrate {

/// The calibration file while it is being made. Each joint is on disk as soon as it is known; the
/// file is replaced as a whole, so whoever reads it sees it before or after, and a crash leaves one
/// of both.
class Record {
 public:
  /// Reads the file; one that is not there begins with every joint absent. Throws config::Error.
  explicit Record(std::filesystem::path path);

  [[nodiscard]] const Calibration& calibration() const { return calibration_; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// Throws config::Error if the bridge could not read the entry (the file is as it was), and
  /// std::runtime_error naming the path if it cannot be written.
  void set(std::size_t joint, const JointCalibration& c, const std::string& note);

 private:
  std::filesystem::path path_;
  std::string text_;
  Calibration calibration_;
};

}  // namespace scarab::bridge::calibrate
