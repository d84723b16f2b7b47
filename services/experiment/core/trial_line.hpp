#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace scarab::experiment {

/// What ends a trial with success. Values equal those of the IDL enumeration GoalKind.
enum class Goal { kNone, kTravel, kAcross, kWalk };

/// The words of a trial line.
inline constexpr std::array<std::pair<std::string_view, Goal>, 4> kGoalNames = {
    {{"travel", Goal::kTravel},
     {"across", Goal::kAcross},
     {"walk", Goal::kWalk},
     {"none", Goal::kNone}}};

inline constexpr auto enum_names(Goal /*kind*/) { return kGoalNames; }

/// One trial that a worker is told to run: all that its result depends on, but for the
/// configuration.
struct TrialLine {
  std::optional<std::uint64_t> index;  ///< its place in the plan; the worker only says it again
  std::string strategy;
  Goal goal = Goal::kNone;
  double height_m = 0;    ///< of the obstacle; 0: none
  double distance_m = 0;  ///< for travel and walk
  double time_limit_s = 0;
  std::uint64_t seed = 0;
  double perturb_position_m = 0;  ///< start position: uniform in +- this, x and y
  double perturb_yaw_rad = 0;     ///< start heading: uniform in +- this
  double perturb_friction = 0;    ///< each coefficient: uniform in 1 +- this
  bool perturb_cpg_phase = false;
  double friction_scale = 1;
  double object_mass_kg = 0;     ///< 0: as configured
  double object_diameter_m = 0;  ///< 0: as configured
};

}  // namespace scarab::experiment
