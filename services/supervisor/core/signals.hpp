#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

/// The two sensor signals that switch behaviours. Both keep their memory in plain structs that are
/// part of MachineState.
namespace scarab::supervisor {

/// Longest averaging window of AS, ticks.
inline constexpr std::size_t kMaxWindowTicks = 64;

/// Exponential mean, from 0: a robot that stands level.
struct ExponentialMean {
  double value = 0;
};

/// mean += smoothing (sample - mean). A sample that is not finite is passed over: one bad reading
/// must not blind the mean for ever.
double update(ExponentialMean& mean, double sample, double smoothing);

/// The newest samples, for a mean over a window that need not be a whole number of ticks.
struct MovingWindow {
  std::array<double, kMaxWindowTicks + 1> sample{};  ///< ring
  std::uint32_t next = 0;                            ///< place of the next sample
  std::uint32_t count = 0;                           ///< samples held, at most the ring's size
};

/// Adds a sample (passed over if it is not finite).
void push(MovingWindow& window, double sample);

/// Mean of the newest `width` samples: each counts 1, and the one after the last whole sample
/// counts the fractional rest, so that a ripple with the period `width` averages out. With fewer
/// samples held, the mean of these; 0 with none.
double mean(const MovingWindow& window, double width);

/// Whether the window holds all the samples that a mean over `width` needs.
bool covers(const MovingWindow& window, double width);

}  // namespace scarab::supervisor
