#include "services/robot_bridge/core/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace scarab::bridge {
namespace {

/// The joint with the largest value; none where no joint tells one.
std::optional<std::size_t> worst_joint(const robot::JointVector& values) {
  std::optional<std::size_t> worst;
  for (std::size_t slot = 0; slot < values.size(); ++slot) {
    if (std::isnan(values[slot])) continue;
    if (!worst || values[slot] > values[*worst]) worst = slot;
  }
  return worst;
}

/// How a value is told and what it is measured against.
struct Watched {
  std::string_view what;  ///< such as "CL0 draws"
  double value;
  std::string_view unit;
  double limit;
  double clear_fraction;
};

void watch(ConfirmedAlarm& alarm, const Watched& w) {
  Level level = Level::kBetween;
  if (w.value > w.limit) level = Level::kBeyond;
  if (w.value < w.clear_fraction * w.limit) level = Level::kWithin;
  // The text is made for the one reading in thousands that may need it.
  const std::string reason =
      level == Level::kBeyond
          ? fmt::format("{} {:.2f} {}, more than {:g} {}", w.what, w.value, w.unit, w.limit, w.unit)
          : "";
  alarm.observe(level, reason);
}

void watch_joints(ConfirmedAlarm& alarm, const robot::JointVector& values, std::string_view verb,
                  std::string_view unit, double limit, double clear_fraction) {
  const auto worst = worst_joint(values);
  if (!worst) return;
  const std::string what = fmt::format("{} {}", robot::kJointNames[*worst], verb);
  watch(alarm, {what, values[*worst], unit, limit, clear_fraction});
}

}  // namespace

Limits::Limits(const LimitsConfig& config)
    : config_(config),
      device_(config.confirm_readings),
      temperature_(config.confirm_readings),
      joint_current_(config.confirm_readings),
      supply_current_(config.confirm_readings),
      inclination_(config.confirm_readings) {}

void Limits::observe(const Readings& readings) {
  const double clear = config_.clear_fraction;
  device_.observe(readings.device_error.empty() ? Level::kWithin : Level::kBeyond,
                  readings.device_error);
  if (config_.temperature_max_c) {
    watch_joints(temperature_, readings.temperature_c, "has", "C", *config_.temperature_max_c,
                 clear);
  }
  if (config_.joint_current_max_a) {
    watch_joints(joint_current_, readings.current_a, "draws", "A", *config_.joint_current_max_a,
                 clear);
  }
  if (config_.supply_current_max_a && readings.supply_current_source == Source::kMeasured) {
    watch(supply_current_, {"the robot draws", readings.supply_current_a, "A",
                            *config_.supply_current_max_a, clear});
  }
  if (config_.inclination_max_rad && readings.imu_source == Source::kMeasured) {
    const double tilt_rad = std::max(std::abs(readings.roll_rad), std::abs(readings.pitch_rad));
    watch(inclination_, {"the trunk leans", tilt_rad, "rad", *config_.inclination_max_rad, clear});
  }
}

void Limits::forget() { *this = Limits(config_); }

std::optional<std::string> Limits::alarm() const {
  for (const ConfirmedAlarm* alarm :
       {&device_, &temperature_, &joint_current_, &supply_current_, &inclination_}) {
    if (alarm->raised()) return alarm->reason();
  }
  return std::nullopt;
}

}  // namespace scarab::bridge
