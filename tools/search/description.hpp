#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/config/document.hpp"

/// What a search is asked for: config/search/*.yaml. Pure data; docs/search.md says what each means
/// for the objective.
namespace scarab::search {

/// Configuration files of the robot that is searched for, relative to the description's folder.
struct BaseNames {
  std::string robot, plant, premotor, supervisor;
};

/// Interval of a parameter; its start is what the base file says.
struct Bounds {
  double low = 0;
  double high = 0;
};

enum class Goal { kTravel, kAcross, kWalk, kNone };

/// What a scenario wants of its trials.
enum class Wanted {
  kSuccess,   ///< the goal, soon
  kFailure,   ///< the goal not reached (such as hard pushing alone on the flat)
  kStraight,  ///< the goal, with the heading kept
};

/// By how much trials differ from each other.
struct Perturbation {
  double position_m = 0.02;
  double yaw_rad = 0.05235987755982988;  ///< 3 deg
  double friction = 0.10;
  bool cpg_phase = true;
};

/// A kind of trial, and what is wanted of it.
struct Scenario {
  std::string name;
  std::string strategy;
  Goal goal = Goal::kAcross;
  double height_m = 0;       ///< of the obstacle; 0: none
  double distance_m = 1.46;  ///< for goals travel and walk
  double time_limit_s = 60;  ///< simulated
  unsigned seeds = 1;        ///< trials per candidate and generation
  double weight = 1;         ///< of its mean cost in the objective
  Wanted wanted = Wanted::kSuccess;
  double heading_bound_rad = 0.17453292519943295;  ///< for straight; 10 deg
  double friction_scale = 1;
  double object_mass_kg = 0;     ///< 0: as configured
  double object_diameter_m = 0;  ///< 0: as configured
};

/// Added to the objective: weight times a term that is 0 up to the bound and grows to 1 at `worst`.
struct Penalty {
  double bound = 0;
  double worst = 1;
  double weight = 0;
};

/// The term is calculated for each trial and averaged like its cost.
struct Penalties {
  Penalty leg_leg_share;       ///< share of the samples in which legs of the robot touch
  Penalty carry_share;         ///< mean share of the object's weight on trunk, coxae and femora
  Penalty approach_pitch_rad;  ///< largest |BS| before the robot first touches the object
};

/// The successes of one scenario are to take less of its time limit than another's: a finding about
/// an order.
struct Order {
  std::string faster, slower;  ///< names of scenarios
  double margin = 0;           ///< of the mean share of the time limit
  double weight = 1;
};

struct SeedRange {
  std::uint64_t first = 0;
  std::uint64_t last = 0;
};

struct Seeds {
  SeedRange search;      ///< drawn anew each generation
  SeedRange validation;  ///< all of them, each time, for the choice of the winner
  SeedRange held_out;    ///< for `evaluate --held-out`; no search ever sees one
};

struct Optimiser {
  unsigned population = 16;      ///< candidates per island and generation
  double sigma = 0.15;           ///< first standard deviation, share of each parameter's interval
  unsigned validate_every = 10;  ///< generations
};

struct Description {
  std::string title;
  BaseNames base;
  std::map<std::string, double> overrides;   ///< while searching only: path -> number
  std::map<std::string, Bounds> parameters;  ///< path -> interval
  std::map<std::string, std::string> ties;   ///< path -> path it equals, or name of a function
  Perturbation perturbation;
  std::vector<Scenario> scenarios;
  Penalties penalties;
  std::vector<Order> orders;
  Seeds seeds;
  Optimiser optimiser;
  double give_up_s = 10;  ///< a trial in which nothing has moved for so long is abandoned
};

/// Searches take seeds below it, reported experiments seeds above.
inline constexpr std::uint64_t kFirstReportedSeed = 1000000;

/// Reads a description and what holds within it. Throws config::Error (`file:line:col: key:
/// reason`).
[[nodiscard]] Description read_description(const config::Document& document);

/// YAML with every key, which reads back to an equal description.
[[nodiscard]] std::string dump_description(const Description& description);

/// JSON Schema of the files (config/schema/search.json).
[[nodiscard]] std::string description_schema();

}  // namespace scarab::search
