#include "tools/topic/delay_meter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/config/json_object.hpp"
#include "tools/topic/failure.hpp"
#include "tools/topic/moments.hpp"
#include "tools/topic/quantity.hpp"

namespace scarab::topic {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;

std::int64_t whole_number(const std::optional<sample::Scalar>& value) {
  if (!value) return 0;  // no element of a sequence: refused by begin()
  if (const auto* integer = std::get_if<std::int64_t>(&*value)) return *integer;
  return static_cast<std::int64_t>(std::get<std::uint64_t>(*value));
}

bool is_whole_number(const sample::FieldPath& path) {
  const auto* primitive = std::get_if<sample::Primitive>(&sample::resolve(*path.type()).kind);
  if (path.is_length() || primitive == nullptr) return false;
  return *primitive != sample::Primitive::kBoolean && *primitive != sample::Primitive::kChar &&
         *primitive != sample::Primitive::kFloat && *primitive != sample::Primitive::kDouble;
}

bool has_64_bits(const sample::FieldPath& path) {
  const auto primitive = std::get<sample::Primitive>(sample::resolve(*path.type()).kind);
  return primitive == sample::Primitive::kInt64 || primitive == sample::Primitive::kUint64;
}

/// The path itself, or those of its seconds and nanoseconds.
std::vector<sample::FieldPath> time_paths(const sample::TypeModel& model,
                                          const std::string& field) {
  std::vector<sample::FieldPath> paths{{model, field}};
  if (!paths[0].is_scalar()) {
    paths = {{model, field + ".sec"}, {model, field + ".nanosec"}};
  }
  for (const sample::FieldPath& path : paths) {
    if (!is_whole_number(path)) throw bus::Error(path.text() + " is no whole number");
  }
  if (paths.size() == 1 && !has_64_bits(paths[0])) {
    throw bus::Error(field + " is no time: ns in 64 bits, or a stamp of sec and nanosec");
  }
  return paths;
}

/// The smallest value that a share of the sorted ones does not exceed.
double percentile(std::vector<double>& values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto rank =
      static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(values.size())));
  const auto nth = values.begin() + std::max<std::ptrdiff_t>(rank - 1, 0);
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

}  // namespace

struct DelayMeter::Summary {
  Moments delay_s;
  double median_s;
  double p95_s;
  double p99_s;
};

void DelayMeter::Part::add(const Part& other) {
  delays_s.insert(delays_s.end(), other.delays_s.begin(), other.delays_s.end());
}

void DelayMeter::begin(const sample::TypeModel* model) {
  if (field_.empty()) return;
  if (model == nullptr) {
    throw Failure(kExitNoType, "--field " + field_ + ": the type is not understood");
  }
  refuse_bad_usage("--field", [&] {
    values_ = std::make_unique<sample::FieldValues>(*model, time_paths(*model, field_));
  });
}

std::int64_t DelayMeter::made_at_ns(const bus::RawSample& sample) const {
  if (!values_) return sample.source_ns;
  const auto values = values_->read(sample.cdr);
  const std::int64_t first = whole_number(values[0]);
  return values.size() == 1 ? first : first * kSecond_ns + whole_number(values[1]);
}

void DelayMeter::add(const bus::RawSample& sample) {
  parts_.now().delays_s.push_back(static_cast<double>(sample.reception_ns - made_at_ns(sample)) *
                                  1e-9);
}

void DelayMeter::end_second(double /*elapsed_s*/, std::size_t seconds) {
  parts_.end_second(seconds);
}

DelayMeter::Summary DelayMeter::summary() const {
  Part all = parts_.sum();
  Summary out{};
  for (const double delay : all.delays_s) out.delay_s.add(delay);
  out.median_s = percentile(all.delays_s, 0.5);
  out.p95_s = percentile(all.delays_s, 0.95);
  out.p99_s = percentile(all.delays_s, 0.99);
  return out;
}

std::vector<Meter::Column> DelayMeter::columns() const {
  return {{"delay", "mean ms"}, {"", "min ms"}, {"", "50 % ms"}, {"", "95 % ms"},
          {"", "99 % ms"},      {"", "max ms"}, {"samples", ""}};
}

std::vector<std::string> DelayMeter::row() const {
  const Summary sum = summary();
  const auto milliseconds = [&](double seconds) {
    return sum.delay_s.count() == 0 ? "-" : fixed(seconds * 1e3, 3);
  };
  return {milliseconds(sum.delay_s.mean()),
          milliseconds(sum.delay_s.min()),
          milliseconds(sum.median_s),
          milliseconds(sum.p95_s),
          milliseconds(sum.p99_s),
          milliseconds(sum.delay_s.max()),
          std::to_string(sum.delay_s.count())};
}

std::string DelayMeter::json() const {
  const Summary sum = summary();
  return config::JsonObject()
      .number("delay_mean_s", sum.delay_s.mean())
      .number("delay_min_s", sum.delay_s.min())
      .number("delay_p50_s", sum.median_s)
      .number("delay_p95_s", sum.p95_s)
      .number("delay_p99_s", sum.p99_s)
      .number("delay_max_s", sum.delay_s.max())
      .number("samples", sum.delay_s.count())
      .str();
}

}  // namespace scarab::topic
