#include "services/plant/core/referee.hpp"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace scarab::plant {
namespace {

[[gnu::format(printf, 1, 2)]] std::string sentence(const char* format, ...) {
  char text[128];  // as long as the topic's field
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return text;
}

}  // namespace

Referee::Referee(const RefereeConfig& config, const TrialSpec& trial, const Wall& wall)
    : config_(config), trial_(trial), wall_(wall) {}

Ruling Referee::judge(const Standing& now) const {
  const auto success = [&](std::string reason) {
    return Ruling{Verdict::kSuccess, now.time_s, std::move(reason)};
  };
  const auto failure = [&](std::string reason) {
    return Ruling{Verdict::kFailure, now.time_s, std::move(reason)};
  };
  const double past_wall = wall_.x - now.object.x();
  if (trial_.goal == Goal::kTravel && now.object_travel_m >= trial_.goal_distance_m) {
    return success(sentence("the object travelled %.3f m of %.3f m in %.1f s", now.object_travel_m,
                            trial_.goal_distance_m, now.time_s));
  }
  if (trial_.goal == Goal::kAcross && past_wall >= config_.across_margin_m) {
    return success(sentence("the object's axis is %.3f m past the %.3f m obstacle after %.1f s",
                            past_wall, wall_.height, now.time_s));
  }
  if (trial_.goal == Goal::kWalk && now.trunk_travel_m >= trial_.goal_distance_m) {
    return success(sentence("the robot walked %.3f m of %.3f m in %.1f s", now.trunk_travel_m,
                            trial_.goal_distance_m, now.time_s));
  }
  if (now.trunk_tilt_rad > config_.overturned_tilt_rad) {
    return failure(sentence("the robot overturned: tilt %.2f rad, limit %.2f rad",
                            now.trunk_tilt_rad, config_.overturned_tilt_rad));
  }
  if (trial_.goal == Goal::kTravel || trial_.goal == Goal::kAcross) {
    const double apart = std::abs(now.trunk_end.x() - now.object.x());
    if (apart > config_.lost_distance_m) {
      return failure(sentence("the object was lost: %.2f m from the trunk's end, limit %.2f m",
                              apart, config_.lost_distance_m));
    }
    const double sideways = std::abs(now.trunk_end.y() - now.object.y());
    if (sideways > config_.lost_sideways_m) {
      return failure(sentence("the object was lost: %.2f m sideways of the trunk, limit %.2f m",
                              sideways, config_.lost_sideways_m));
    }
  }
  // Times are whole ticks; half a nanosecond forgives their conversion.
  if (now.time_s + 0.5e-9 < trial_.time_limit_s) return {};
  if (trial_.goal == Goal::kNone) {
    return success(sentence("ran to the time limit of %.1f s", trial_.time_limit_s));
  }
  if (trial_.goal == Goal::kWalk) {
    return failure(sentence("time limit of %.1f s: the robot walked %.3f m", trial_.time_limit_s,
                            now.trunk_travel_m));
  }
  return failure(sentence("time limit of %.1f s: the object travelled %.3f m", trial_.time_limit_s,
                          now.object_travel_m));
}

Standing standing(const MotionState& state, double time_s, double trunk_half_length_m,
                  const StartPlaces& start) {
  Standing out;
  out.time_s = time_s;
  out.trunk_end =
      state.trunk_position + state.trunk_orientation * Eigen::Vector3d(-trunk_half_length_m, 0, 0);
  const Eigen::Vector3d up = state.trunk_orientation * Eigen::Vector3d::UnitZ();
  out.trunk_tilt_rad = std::acos(std::clamp(up.z(), -1.0, 1.0));
  out.object = state.object_position;
  out.object_travel_m = start.object_x - state.object_position.x();
  out.trunk_travel_m = (state.trunk_position - start.trunk).head<2>().norm();
  return out;
}

}  // namespace scarab::plant
