#include "tools/drive/adapter.hpp"

#include <algorithm>
#include <iterator>

#include "common/bus/sample_fields.hpp"
#include "common/runtime/words.hpp"
#include "services/supervisor/core/mode.hpp"

namespace scarab::drive {
namespace {

using runtime::ServiceReport;

constexpr double kNearlyAll = 0.99;
const std::string kRefused = "commands_refused_";
const std::string kClamped = "targets_clamped_";

bool begins_with(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

Concern concern_of(scarab_Health health) {
  switch (health) {
    case scarab_HEALTH_OK:
      return Concern::kNone;
    case scarab_HEALTH_WAITING:
      return Concern::kWaits;
    case scarab_HEALTH_DEGRADED:
      return Concern::kDegraded;
    case scarab_HEALTH_FAULT:
      return Concern::kFault;
  }
  return Concern::kFault;
}

const runtime::Histogram& histogram(const ServiceReport& report, const std::string& name) {
  static const runtime::Histogram none;
  const auto entry = report.histograms.find(name);
  return entry == report.histograms.end() ? none : entry->second;
}

/// In one whose device is lost or whose motors are off the tick master is inactive: then it stands
/// in the trial that was heard of last, which has not ended.
bool runs_trial(const Live& live, const ServiceReport& report) {
  if (report.lifecycle == scarab_LIFECYCLE_ACTIVE) return true;
  const bool is_heard_of = live.trial != 0 && live.trial == report.header.trial && !live.trial_over;
  const bool stands =
      begins_with(report.message, "safe stop") || begins_with(report.message, "paused");
  return report.lifecycle == scarab_LIFECYCLE_INACTIVE && is_heard_of && stands;
}

void see_tick_master(Live& live, const ServiceReport& report) {
  live.tick_master_answers = true;
  live.tick_master_says = report.message;
  live.trial_runs = runs_trial(live, report);
  live.safe_stop = begins_with(report.message, "safe stop");
  for (const auto& [name, count] : report.counters) {
    if (begins_with(name, kClamped)) live.clamped += count;
    if (begins_with(name, kRefused) && count > 0) {
      live.refused.emplace_back(name.substr(kRefused.size()), count);
    }
  }
  const auto& jitter = histogram(report, "tick_jitter");
  const auto& age = histogram(report, "command_age");
  live.timing = {jitter.quantile_s(kNearlyAll), jitter.max_s(), age.quantile_s(kNearlyAll),
                 age.max_s()};
}

}  // namespace

void see(Live& live, const scarab_RobotState& state) {
  live.trial = state.header.trial;
  live.tick = state.header.tick;
  live.time_s = static_cast<double>(state.header.sim_time_ns) * 1e-9;
  live.real_time = state.real_time;
  live.phase = runtime::word(state.phase);
  live.trial_over = state.phase == scarab_PHASE_SUCCEEDED || state.phase == scarab_PHASE_FAILED;
  for (std::size_t slot = 0; slot < robot::kJointCount; ++slot) {
    live.position_rad[slot] = state.position_rad[slot];
    live.has_joint[slot] = state.position_source[slot] != scarab_SOURCE_ABSENT;
  }
}

void see(Live& live, const scarab_Behaviour& behaviour) {
  live.state = runtime::word(behaviour.state);
  live.reason = bus::text(behaviour.reason);
  live.mode = supervisor::name(static_cast<supervisor::Mode>(behaviour.mode));
  std::copy(std::begin(behaviour.inputs), std::end(behaviour.inputs), live.inputs.begin());
  live.bs_rad = behaviour.bs_rad;
  live.bs_threshold_rad = behaviour.bs_threshold_rad;
  live.as_rad = behaviour.as_rad;
  live.as_threshold_rad = behaviour.as_threshold_rad;
  live.by_load = behaviour.trigger == scarab_TRIGGER_SUPPLY_CURRENT ||
                 behaviour.trigger == scarab_TRIGGER_FOOT_FORCE;
  live.trigger = runtime::word(behaviour.trigger);
  live.trigger_unit = behaviour.trigger == scarab_TRIGGER_FOOT_FORCE ? "N" : "A";
  live.trigger_value = behaviour.trigger_value;
  live.trigger_threshold = behaviour.trigger_threshold;
}

void see(Live& live, const std::map<bus::Peer, ServiceReport>& reports,
         const std::string& tick_master) {
  live.tick_master = tick_master;
  live.tick_master_says.clear();
  live.tick_master_answers = live.trial_runs = live.safe_stop = false;
  live.refused.clear();
  live.clamped = 0;
  live.timing = {};
  live.services.clear();
  for (const auto& [peer, report] : reports) {
    const std::string who = bus::to_string(peer);
    live.services.push_back(
        {who, runtime::word(report.lifecycle), concern_of(report.health), report.message});
    if (who == tick_master) see_tick_master(live, report);
  }
}

}  // namespace scarab::drive
