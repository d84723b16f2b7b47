#include "tools/topic/bandwidth_meter.hpp"

#include "common/config/json_object.hpp"
#include "tools/topic/quantity.hpp"

namespace scarab::topic {

void BandwidthMeter::Part::add(const Part& other) {
  elapsed_s += other.elapsed_s;
  size_bytes.add(other.size_bytes);
}

void BandwidthMeter::add(const bus::RawSample& sample) {
  parts_.now().size_bytes.add(static_cast<double>(sample.cdr.size));
}

void BandwidthMeter::end_second(double elapsed_s, std::size_t seconds) {
  parts_.now().elapsed_s = elapsed_s;
  parts_.end_second(seconds);
}

std::vector<Meter::Column> BandwidthMeter::columns() const {
  return {{"data", "per s"}, {"samples", "per s"}, {"size", "mean"},
          {"", "min"},       {"", "max"},          {"samples", ""}};
}

std::vector<std::string> BandwidthMeter::row() const {
  const Part sum = parts_.sum();
  const auto size = [&](double bytes) {
    return sum.size_bytes.count() == 0 ? "-" : bytes_text(bytes);
  };
  return {bytes_text(sum.per_second(sum.bytes())),
          fixed(sum.per_second(sum.samples()), 1),
          size(sum.size_bytes.mean()),
          size(sum.size_bytes.min()),
          size(sum.size_bytes.max()),
          std::to_string(sum.size_bytes.count())};
}

std::string BandwidthMeter::json() const {
  const Part sum = parts_.sum();
  return config::JsonObject()
      .number("bytes_per_s", sum.per_second(sum.bytes()))
      .number("samples_per_s", sum.per_second(sum.samples()))
      .number("size_mean_bytes", sum.size_bytes.mean())
      .number("size_min_bytes", sum.size_bytes.min())
      .number("size_max_bytes", sum.size_bytes.max())
      .number("samples", sum.size_bytes.count())
      .number("window_s", sum.elapsed_s)
      .str();
}

}  // namespace scarab::topic
