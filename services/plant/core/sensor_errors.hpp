#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "services/plant/core/sensor_config.hpp"

namespace scarab::plant {

/// The errors of one sensor, each a pure function of (seed, sensor, element, sample) and never of
/// what was asked before:
///
///     reading = q round((truth(t - latency) + b_i + sigma g_i,n) / q)
///
/// for element i (a joint, a foot, an axis) of sample n; b_i ~ bias N(0, 1) drawn once a trial,
/// g_i,n ~ N(0, 1), q the quantum. Latency and the hold after a lost sample are the caller's, who
/// knows the past (sensor_readings.hpp).
class SensorErrorModel {
 public:
  /// `sensor` names the random streams: equal names draw equal numbers.
  SensorErrorModel(const SensorErrors& errors, std::string_view sensor, std::uint64_t seed);

  /// What the element reads for `truth`. Without errors it is `truth`, to the bit.
  [[nodiscard]] double reading(double truth, std::size_t element, std::uint64_t sample) const;

  /// The element's constant offset b_i in this trial.
  [[nodiscard]] double bias(std::size_t element) const;

  /// Whether that sample never arrived. Sample 0 always does: a reading exists before a trial
  /// starts.
  [[nodiscard]] bool lost(std::size_t element, std::uint64_t sample) const;

 private:
  SensorErrors errors_;
  std::uint64_t seed_;
  std::uint64_t noise_stream_;
  std::uint64_t bias_stream_;
  std::uint64_t loss_stream_;
};

}  // namespace scarab::plant
