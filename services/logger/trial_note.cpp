#include "services/logger/trial_note.hpp"

#include <array>
#include <charconv>
#include <string>

#include "common/bus/cdr.hpp"
#include "common/bus/error.hpp"
#include "common/bus/topics.hpp"
#include "services/logger/utc_time.hpp"

namespace scarab::logger {
namespace {

const char* word(scarab_GoalKind goal) {
  switch (goal) {
    case scarab_GOAL_NONE:
      return "none";
    case scarab_GOAL_TRAVEL:
      return "travel";
    case scarab_GOAL_ACROSS:
      return "across";
    case scarab_GOAL_WALK:
      return "walk";
  }
  return "unknown";
}

/// The shortest text that reads back as the same number.
std::string text(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), end.ptr};
}

std::map<std::string, std::string> entries(const scarab_Trial& trial) {
  return {{"number", std::to_string(trial.header.trial)},
          {"announced", utc_text(trial.header.stamp_ns)},
          {"announced_ns", std::to_string(trial.header.stamp_ns)},
          {"strategy", trial.strategy},
          {"seed", std::to_string(trial.seed)},
          {"goal", word(trial.goal)},
          {"goal_distance_m", text(trial.goal_distance_m)},
          {"time_limit_s", text(trial.time_limit_s)},
          {"obstacle_height_m", text(trial.obstacle_height_m)},
          {"object_mass_kg", text(trial.object_mass_kg)},
          {"object_diameter_m", text(trial.object_diameter_m)},
          {"friction_scale", text(trial.friction_scale)},
          {"perturb_position_m", text(trial.perturb_position_m)},
          {"perturb_yaw_rad", text(trial.perturb_yaw_rad)},
          {"perturb_cpg_phase", trial.perturb_cpg_phase ? "true" : "false"},
          {"perturb_friction", text(trial.perturb_friction)}};
}

}  // namespace

std::optional<TrialNote> read_trial_note(mcap::ByteView cdr) {
  try {
    const auto trial =
        bus::decode<scarab_Trial>({reinterpret_cast<const std::byte*>(cdr.data()), cdr.size()});
    return TrialNote{trial->header.trial, {"scarab.trial", entries(*trial)}};
  } catch (const bus::Error&) {
    return std::nullopt;
  }
}

}  // namespace scarab::logger
