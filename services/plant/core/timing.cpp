#include "services/plant/core/timing.hpp"

#include <cmath>
#include <stdexcept>

namespace scarab::plant {
namespace {

std::int64_t whole_ns(double seconds, const char* name) {
  if (!(seconds >= 1e-9 && seconds < 1e6)) {
    throw std::invalid_argument(std::string(name) + " must be positive");
  }
  return std::llround(seconds * 1e9);
}

std::int64_t ratio(std::int64_t longer, std::int64_t shorter, const char* names) {
  if (longer % shorter != 0) {
    throw std::invalid_argument(std::string(names) + " is not a whole number");
  }
  return longer / shorter;
}

}  // namespace

Timing make_timing(const TimingConfig& config) {
  Timing out;
  out.step_ns = whole_ns(config.step_s, "step_s");
  out.sensor_period_ns = whole_ns(config.sensor_period_s, "sensor_period_s");
  const std::int64_t control_ns = whole_ns(config.control_period_s, "control_period_s");
  out.steps_per_sample = ratio(out.sensor_period_ns, out.step_ns, "sensor_period_s / step_s");
  out.samples_per_tick =
      ratio(control_ns, out.sensor_period_ns, "control_period_s / sensor_period_s");
  return out;
}

std::int64_t whole_steps(double time_s, std::int64_t step_ns, const std::string& name) {
  if (!(time_s >= 0 && time_s < 1e6)) throw std::invalid_argument(name + " must not be negative");
  const std::int64_t time_ns = std::llround(time_s * 1e9);
  if (time_ns % step_ns != 0) {
    throw std::invalid_argument(name + " is not a whole number of steps (step_s)");
  }
  return time_ns / step_ns;
}

}  // namespace scarab::plant
