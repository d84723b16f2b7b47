#include "tools/topic/rate_meter.hpp"

#include "common/config/json_object.hpp"
#include "tools/topic/quantity.hpp"

namespace scarab::topic {

void RateMeter::Part::add(const Part& other) {
  samples += other.samples;
  elapsed_s += other.elapsed_s;
  interval_s.add(other.interval_s);
}

double RateMeter::rate_hz(const Part& part) {
  return part.elapsed_s > 0.0 ? static_cast<double>(part.samples) / part.elapsed_s : 0.0;
}

void RateMeter::add(const bus::RawSample& sample) {
  Part& part = parts_.now();
  ++part.samples;
  if (last_ns_) part.interval_s.add(static_cast<double>(sample.reception_ns - *last_ns_) * 1e-9);
  last_ns_ = sample.reception_ns;
}

void RateMeter::end_second(double elapsed_s, std::size_t seconds) {
  parts_.now().elapsed_s = elapsed_s;
  parts_.end_second(seconds);
}

std::vector<Meter::Column> RateMeter::columns() const {
  return {{"rate", "Hz"}, {"interval", "mean ms"}, {"", "min ms"},
          {"", "max ms"}, {"", "stddev ms"},       {"samples", ""}};
}

std::vector<std::string> RateMeter::row() const {
  const Part sum = parts_.sum();
  const auto milliseconds = [&](double seconds) {
    return sum.interval_s.count() == 0 ? "-" : fixed(seconds * 1e3, 3);
  };
  return {fixed(rate_hz(sum), 1),
          milliseconds(sum.interval_s.mean()),
          milliseconds(sum.interval_s.min()),
          milliseconds(sum.interval_s.max()),
          milliseconds(sum.interval_s.standard_deviation()),
          std::to_string(sum.samples)};
}

std::string RateMeter::json() const {
  const Part sum = parts_.sum();
  return config::JsonObject()
      .number("rate_hz", rate_hz(sum))
      .number("interval_mean_s", sum.interval_s.mean())
      .number("interval_min_s", sum.interval_s.min())
      .number("interval_max_s", sum.interval_s.max())
      .number("interval_stddev_s", sum.interval_s.standard_deviation())
      .number("samples", sum.samples)
      .number("window_s", sum.elapsed_s)
      .str();
}

}  // namespace scarab::topic
