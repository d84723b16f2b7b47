#include "services/experiment/adapter.hpp"

#include "common/runtime/words.hpp"

namespace scarab::experiment {
namespace {

constexpr double kSecondsPerNs = 1e-9;

}  // namespace

TrialWatch::TrialWatch(const scarab_Trial& trial) {
  outcome_.number = trial.header.trial;
  outcome_.strategy = trial.strategy;
  outcome_.height_m = trial.obstacle_height_m;
  outcome_.seed = trial.seed;
}

void TrialWatch::see(const scarab_Behaviour& behaviour) {
  if (behaviour.header.trial != outcome_.number || state_ == behaviour.state) return;
  state_ = behaviour.state;
  outcome_.end.state = runtime::word(behaviour.state);
  outcome_.changes.push_back({static_cast<double>(behaviour.header.sim_time_ns) * kSecondsPerNs,
                              outcome_.end.state, behaviour.reason});
}

void TrialWatch::see(const scarab_WorldState& world) {
  if (world.header.trial != outcome_.number || ended_) return;
  const auto now = std::chrono::steady_clock::now();
  if (!started_) started_ = now;
  outcome_.end.time_s = static_cast<double>(world.header.sim_time_ns) * kSecondsPerNs;
  outcome_.end.wall_s = std::chrono::duration<double>(now - *started_).count();
  outcome_.end.travel_m = world.object_travel_m;
  last_tick_ = world.header.tick;
  if (world.verdict == scarab_VERDICT_OPEN) return;
  ended_ = true;
  outcome_.success = world.verdict == scarab_VERDICT_SUCCESS;
  outcome_.reason = world.verdict_reason;
}

void TrialWatch::fail(const std::string& reason) {
  ended_ = true;
  outcome_.success = false;
  outcome_.reason = reason;
}

}  // namespace scarab::experiment
