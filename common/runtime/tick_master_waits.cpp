#include <spdlog/spdlog.h>

#include <algorithm>

#include "common/runtime/tick_master.hpp"

// What a tick master waits for: peers, the operator, commands, the wall clock, the logger.
namespace scarab::runtime {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPoll{5};  // while peers or the logger are waited for
constexpr std::chrono::milliseconds kPausePoll{200};

/// What a service says keeps it from working, as the end of a sentence.
std::string complaint_of(const ServiceReport* report) {
  const bool complains = report && report->health == scarab_HEALTH_FAULT;
  return complains ? ": " + report->message : "";
}

}  // namespace

void TickMaster::await_start() {
  status_.set_health(scarab_HEALTH_OK);
  status_.set_ready(trial_);
  const auto since = Clock::now();
  for (;;) {
    auto unmet = peers_.unmet();
    for (const auto& name : board_.missing(expect_, trial_)) unmet.push_back(name + " to be ready");
    if (unmet.empty()) break;
    if (Clock::now() - since > options_.report_silence) {
      status_.set_health(scarab_HEALTH_WAITING, "waits for " + join(unmet));
    }
    wait(kPoll);
  }
  status_.set_health(scarab_HEALTH_OK);
  status_.set_lifecycle(scarab_LIFECYCLE_ACTIVE);
  spdlog::info("trial {} starts", trial_);
}

void TickMaster::hold_if_paused() {
  if (!desk_.paused()) return;
  flush();
  status_.set_health(scarab_HEALTH_WAITING, "paused by the operator");
  while (desk_.paused() && !body_.verdict()) wait(kPausePoll);
  status_.set_health(scarab_HEALTH_OK);
  pacer_.restart(Clock::now());
}

/// Lockstep: until the command is there; silence is reported, then ends the trial.
void TickMaster::await_command() {
  const auto since = Clock::now();
  while (!answered_) {
    wait(options_.report_silence);
    const auto silent = Clock::now() - since;
    if (answered_ || silent < options_.report_silence) continue;
    const std::string what = who_is_silent() + " has not answered tick " + std::to_string(tick_);
    status_.set_health(scarab_HEALTH_WAITING, what);
    if (silent >= options_.give_up) {
      const std::string reason = what + " for " + std::to_string(options_.give_up.count()) + " s";
      if (!body_.verdict()) body_.end({false, reason});
      body_.publish_own(header());
      flush();
      status_.set_health(scarab_HEALTH_FAULT, reason);
      return;
    }
  }
  if (status_.health() == scarab_HEALTH_WAITING) status_.set_health(scarab_HEALTH_OK);
}

/// Real time: whatever comes meanwhile; the gate's safe stop takes over from too many stale
/// commands.
void TickMaster::await_until(TickPacer::TimePoint time) {
  for (auto left = time - Clock::now(); left.count() > 0; left = time - Clock::now()) wait(left);
}

/// The first expected logger that has not recorded the tick `lead` ticks ago.
std::optional<bus::Peer> TickMaster::logger_behind(std::uint32_t lead) const {
  const auto expected = expect_.find("logger");
  if (expected == expect_.end() || tick_ < lead) return std::nullopt;
  for (std::uint32_t instance = 0; instance < expected->second; ++instance) {
    const auto* logger = board_.find({"logger", instance});
    if (!logger || logger->recorded_trial != trial_ || logger->recorded_tick + lead < tick_) {
      return bus::Peer{"logger", instance};
    }
  }
  return std::nullopt;
}

/// Keeps the lead over every expected logger small enough that nothing it has not received yet is
/// overwritten in a writer's history. Two ticks less: the running one, and the last one's samples
/// that leave with it.
void TickMaster::await_logger() {
  if (options_.pace != Pace::kLockstep) return;
  const std::uint32_t kept = std::min(bus::kDepth, bus::kStreamDepth / options_.samples_per_tick);
  const std::uint32_t lead = std::max(3U, kept) - 2;
  const auto since = Clock::now();
  while (const auto logger = logger_behind(lead)) {
    wait(kPoll);
    const auto silent = Clock::now() - since;
    if (silent < options_.report_silence) continue;
    const std::string what =
        bus::to_string(*logger) + " has not recorded tick " + std::to_string(tick_ - lead);
    const std::string why = complaint_of(board_.find(*logger));
    status_.set_health(scarab_HEALTH_WAITING, what + why);
    if (silent < options_.give_up) continue;
    body_.end({false, what + " for " + std::to_string(options_.give_up.count()) + " s" + why});
    return;
  }
  if (status_.health() == scarab_HEALTH_WAITING) status_.set_health(scarab_HEALTH_OK);
}

void TickMaster::wait(std::chrono::nanoseconds timeout) {
  status_.publish_if_due();
  wait_set_.wait(timeout);
  if (shutdown_.requested()) throw Interrupted{};
  take_trials();
  board_.update();
  take_operator();
  take_commands();
}

std::string TickMaster::who_is_silent() const {
  return behaviour_tick_ >= static_cast<std::int64_t>(tick_) ? "premotor" : "supervisor";
}

}  // namespace scarab::runtime
