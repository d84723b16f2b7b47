#include "services/experiment/adapter.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "common/bus/sample_fields.hpp"
#include "common/runtime/words.hpp"

namespace scarab::experiment {
namespace {

constexpr bool same(Goal core, scarab_GoalKind idl) {
  return static_cast<int>(core) == static_cast<int>(idl);
}

static_assert(same(Goal::kNone, scarab_GOAL_NONE) && same(Goal::kTravel, scarab_GOAL_TRAVEL) &&
              same(Goal::kAcross, scarab_GOAL_ACROSS) && same(Goal::kWalk, scarab_GOAL_WALK));

/// Divided, not multiplied by 1e-9: a whole number of milliseconds is then written as one.
double seconds(std::int64_t ns) { return static_cast<double>(ns) / 1e9; }

template <std::size_t N>
std::array<double, N> to_array(const double (&from)[N]) {
  std::array<double, N> to;
  std::copy(std::begin(from), std::end(from), to.begin());
  return to;
}

/// The measure that says when this state was first entered; null: none does.
std::optional<double>* entry_of(Measures& measures, scarab_BehaviourState state) {
  switch (state) {
    case scarab_BEHAVIOUR_CLIMB:
      return &measures.climb_s;
    case scarab_BEHAVIOUR_MODE_1:
      return &measures.mode1_s;
    case scarab_BEHAVIOUR_MODE_2:
      return &measures.mode2_s;
    default:
      return nullptr;
  }
}

}  // namespace

scarab_Trial to_trial(const TrialLine& line, std::uint32_t number) {
  scarab_Trial trial{};
  trial.header.trial = number;
  bus::assign(trial.strategy, line.strategy);
  trial.goal = static_cast<scarab_GoalKind>(line.goal);
  trial.goal_distance_m = line.distance_m;
  trial.time_limit_s = line.time_limit_s;
  trial.obstacle_height_m = line.height_m;
  trial.seed = line.seed;
  trial.perturb_position_m = line.perturb_position_m;
  trial.perturb_yaw_rad = line.perturb_yaw_rad;
  trial.perturb_friction = line.perturb_friction;
  trial.perturb_cpg_phase = line.perturb_cpg_phase;
  trial.friction_scale = line.friction_scale;
  trial.object_mass_kg = line.object_mass_kg;
  trial.object_diameter_m = line.object_diameter_m;
  return trial;
}

TrialWatch::TrialWatch(const scarab_Trial& trial, Judge judge) : judge_(judge) {
  outcome_.number = trial.header.trial;
  outcome_.strategy = trial.strategy;
  outcome_.height_m = trial.obstacle_height_m;
  outcome_.seed = trial.seed;
}

void TrialWatch::see(const scarab_Behaviour& behaviour) {
  if (behaviour.header.trial != outcome_.number) return;
  watch_for_gap(behaviour);
  if (state_ == behaviour.state) return;
  state_ = behaviour.state;
  outcome_.end.state = runtime::word(behaviour.state);
  const double time_s = seconds(behaviour.header.sim_time_ns);
  outcome_.changes.push_back({time_s, outcome_.end.state, behaviour.reason});
  auto* entry = entry_of(outcome_.measures, behaviour.state);
  if (entry != nullptr && !*entry) *entry = time_s;
}

void TrialWatch::see(const scarab_WorldState& world) {
  if (world.header.trial != outcome_.number || measured_) return;
  // The two publish on their own: the verdict that the tick master has heard may come after its
  // word here.
  if (ended_ && (judge_ == Judge::kReferee || world.verdict == scarab_VERDICT_OPEN)) return;
  if (judge_ == Judge::kReferee) {
    progress(world.header);
    worlds_.see(world.header.sim_time_ns);
    miss(worlds_.missed());
  }
  outcome_.end.travel_m = world.object_travel_m;
  measure(world);
  if (world.verdict == scarab_VERDICT_OPEN) return;
  measured_ = true;
  referee_ = world.verdict == scarab_VERDICT_SUCCESS;
  referee_reason_ = world.verdict_reason;
  if (judge_ == Judge::kReferee) end(*referee_, referee_reason_);
  if (referee_ == outcome_.success) explain(referee_reason_);
}

void TrialWatch::see(const scarab_RobotState& state) {
  if (judge_ != Judge::kTickMaster || state.header.trial != outcome_.number || ended_) return;
  progress(state.header);
  const bool success = state.phase == scarab_PHASE_SUCCEEDED;
  if (success || state.phase == scarab_PHASE_FAILED) {
    end(success, referee_ == success ? referee_reason_ : "");
  }
}

/// Another tick, or a sample of one.
void TrialWatch::progress(const scarab_Header& header) {
  const auto now = std::chrono::steady_clock::now();
  if (!started_) started_ = now;
  outcome_.end.time_s = seconds(header.sim_time_ns);
  outcome_.end.wall_s = std::chrono::duration<double>(now - *started_).count();
  last_tick_ = header.tick;
}

void TrialWatch::end(bool success, const std::string& reason) {
  ended_ = outcome_.judged = true;
  outcome_.success = success;
  outcome_.reason = reason;
}

void TrialWatch::explain(const std::string& reason) {
  if (wants_reason()) outcome_.reason = reason;
}

/// A gap is none of a fault where the state was the same all the while: a supervisor that was
/// started anew answers at once, and is heard here a little later.
void TrialWatch::watch_for_gap(const scarab_Behaviour& behaviour) {
  const std::int64_t tick = behaviour.header.tick;
  const std::int64_t known = std::max<std::int64_t>(behaviour_tick_, 0);
  if (tick > behaviour_tick_ + 1 && behaviour.entered_tick > known) {
    miss("behaviour of tick " + std::to_string(behaviour_tick_ + 1) + " was missed");
  }
  behaviour_tick_ = std::max(behaviour_tick_, tick);
}

void TrialWatch::measure(const scarab_WorldState& world) {
  const Place now{to_array(world.trunk.position_m), world.object.position_m[1]};
  if (!start_) start_ = now;
  turn_.see(heading_rad(to_array(world.trunk.orientation_wxyz)));
  auto& measures = outcome_.measures;
  measures.object_travel_m = world.object_travel_m;
  measures.object_sideways_m = now.object_y_m - start_->object_y_m;
  measures.trunk_travel_m =
      std::hypot(now.trunk_m[0] - start_->trunk_m[0], now.trunk_m[1] - start_->trunk_m[1]);
  measures.heading_rad = turn_.turned_rad();
  measures.heading_max_rad = turn_.most_rad();
}

void TrialWatch::fail(const std::string& reason) {
  ended_ = true;
  outcome_.success = false;
  outcome_.reason = reason;
}

void TrialWatch::miss(const std::string& what) {
  if (outcome_.missed.empty()) outcome_.missed = what;
}

bool TrialWatch::complete() const {
  const bool last = state_ == scarab_BEHAVIOUR_DONE || state_ == scarab_BEHAVIOUR_FAILED;
  return outcome_.judged && last && behaviour_tick_ >= std::int64_t{last_tick_};
}

}  // namespace scarab::experiment
