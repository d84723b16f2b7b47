#include "services/plant/core/sensor_errors.hpp"

#include <cmath>
#include <string>

#include "common/random/random.hpp"

namespace scarab::plant {
namespace {

std::uint64_t stream_of(std::string_view sensor, std::string_view effect) {
  return random::stream(std::string(sensor) + " " + std::string(effect));
}

}  // namespace

SensorErrorModel::SensorErrorModel(const SensorErrors& errors, std::string_view sensor,
                                   std::uint64_t seed)
    : errors_(errors),
      seed_(seed),
      noise_stream_(stream_of(sensor, "noise")),
      bias_stream_(stream_of(sensor, "bias")),
      loss_stream_(stream_of(sensor, "loss")) {}

double SensorErrorModel::reading(double truth, std::size_t element, std::uint64_t sample) const {
  double out = truth;
  if (errors_.bias > 0) out += bias(element);
  if (errors_.noise > 0) {
    out += errors_.noise * random::gaussian(seed_, noise_stream_ + element, sample);
  }
  if (errors_.quantum > 0) {
    out = errors_.quantum * std::round(out / errors_.quantum) + 0.0;  // + 0.0: never -0
  }
  return out;
}

double SensorErrorModel::bias(std::size_t element) const {
  return errors_.bias * random::gaussian(seed_, bias_stream_ + element, 0);
}

bool SensorErrorModel::lost(std::size_t element, std::uint64_t sample) const {
  return sample > 0 && random::uniform(seed_, loss_stream_ + element, sample) < errors_.dropout;
}

}  // namespace scarab::plant
