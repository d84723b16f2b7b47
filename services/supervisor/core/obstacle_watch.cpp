#include "services/supervisor/core/obstacle_watch.hpp"

#include <array>
#include <cstdio>

namespace scarab::supervisor {
namespace {

/// What a trigger's phrase is made of.
struct Words {
  const char* signal;
  const char* relation;  // of a blocked object
  const char* unit;
};

Words words_of(Trigger trigger) {
  switch (trigger) {
    case Trigger::kFrontAngle:
      return {"AS", "<", "rad"};
    case Trigger::kSupplyCurrent:
      return {"supply current", ">", "A"};
    case Trigger::kFootForce:
      return {"front feet", ">", "N"};
    case Trigger::kNone:
      break;
  }
  return {"none", "-", ""};
}

}  // namespace

ObstacleReading read(const ObstacleSignals& signals, const SupervisorConfig& config,
                     Trigger trigger) {
  const double width = config.as.window_ticks;
  const auto above = [width](const MovingWindow& window, double threshold) {
    const double value = mean(window, width);
    return ObstacleReading{value, threshold, covers(window, width) && value > threshold};
  };
  switch (trigger) {
    case Trigger::kFrontAngle: {
      const double value = mean(signals.front_f_rad, width);
      const double threshold = config.as.reference_rad - config.as.drop_rad;
      return {value, threshold, covers(signals.front_f_rad, width) && value < threshold};
    }
    case Trigger::kSupplyCurrent:
      return above(signals.supply_current_a,
                   config.supply_current.reference_a + config.supply_current.rise_a);
    case Trigger::kFootForce:
      return above(signals.front_foot_n, config.foot_force.reference_n + config.foot_force.rise_n);
    case Trigger::kNone:
      break;
  }
  return {};
}

ObstacleTiming timing_of(const SupervisorConfig& config, Trigger trigger) {
  switch (trigger) {
    case Trigger::kFrontAngle:
      return {config.as.confirm_ticks, config.as.arm_ticks};
    case Trigger::kSupplyCurrent:
      return {config.supply_current.confirm_ticks, config.supply_current.arm_ticks};
    case Trigger::kFootForce:
      return {config.foot_force.confirm_ticks, config.foot_force.arm_ticks};
    case Trigger::kNone:
      break;
  }
  return {};
}

std::string phrase(const ObstacleReading& reading, Trigger trigger) {
  const Words words = words_of(trigger);
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "%s %.3f %s %.3f %s", words.signal, reading.value,
                words.relation, reading.threshold, words.unit);
  return text.data();
}

}  // namespace scarab::supervisor
