#include "common/runtime/status_publisher.hpp"
#include "services/experiment/conductor.hpp"

// What keeps a trial from coming to its end: faults, silence, a tick master that is gone.
namespace scarab::experiment {
namespace {

using Clock = std::chrono::steady_clock;

// A service that was up has had time to say better of itself than of the trial before.
constexpr std::chrono::seconds kPatience{1};
// Beyond the lease of a service's status: what has none has been silent for that long already, or
// we have been without CPU for that long. Who lives says so again meanwhile.
constexpr std::chrono::milliseconds kGonePatience =
    runtime::StatusPublisher::kRepeatPeriod + std::chrono::milliseconds(250);

}  // namespace

/// A service that cannot go on, or a stack gone silent, ends the trial here: no verdict will come.
void Conductor::watch_for_trouble(TrialWatch& watch, std::chrono::seconds silence_limit) {
  if (watch.ended()) return;
  if (const auto reason = fault()) {
    watch.fail(*reason);
    return;
  }
  for (const auto& [peer, report] : board_.reports()) {
    if (report.health == scarab_HEALTH_WAITING && listener_.waiting) {
      listener_.waiting(bus::to_string(peer) + " " + report.message);
    }
  }
  watch_for_absence(watch);
  if (is_homing(watch)) heard_ = Clock::now();
  if (!watch.ended() && Clock::now() - heard_ > silence_limit) {
    std::string reason =
        "nothing heard of the trial for " + std::to_string(silence_limit.count()) + " s";
    const auto missing = board_.missing(expect_, 0);
    if (!missing.empty()) reason += "; gone: " + runtime::join(missing);
    watch.fail(reason);
  }
}

/// Nobody restarts a tick master in the middle of a trial. Its absence counts from the first look
/// that does not find it: before that it may be us who did not run.
void Conductor::watch_for_absence(TrialWatch& watch) {
  const auto now = Clock::now();
  if (!tick_master_ || board_.find(*tick_master_)) {
    master_missed_.reset();
  } else if (!master_missed_) {
    master_missed_ = now;
  }
  master_gone_ = master_missed_ && now - *master_missed_ > kGonePatience;
  if (master_gone_) watch.fail(bus::to_string(*tick_master_) + " is gone");
}

/// On its slow way to the start pose, before its first tick.
bool Conductor::is_homing(const TrialWatch& watch) const {
  if (!states_ || watch.began()) return false;
  const auto* report = board_.find(*tick_master_);
  return report && report->lifecycle == scarab_LIFECYCLE_ACTIVE &&
         report->header.trial == watch.outcome().number;
}

/// The fault is of the trial before: the service has had no time yet to say better.
bool Conductor::left_over(const runtime::ServiceReport& report) const {
  return report.header.stamp_ns < told_ns_ && Clock::now() - told_ < kPatience;
}

std::optional<std::string> Conductor::fault_said(bool by_logger) const {
  for (const auto& [peer, report] : board_.reports()) {
    const bool is_logger = peer.service == "logger";
    if (report.health == scarab_HEALTH_FAULT && !left_over(report) && is_logger == by_logger) {
      return bus::to_string(peer) + ": " + report.message;
    }
  }
  return std::nullopt;
}

/// Why no verdict will come; nothing while all is well. A logger that cannot write is no reason:
/// in lockstep the tick master waits for it, and ends the trial when its patience does.
std::optional<std::string> Conductor::fault() const {
  if (auto reason = fault_.reason()) return reason;
  return fault_said(false);
}

}  // namespace scarab::experiment
