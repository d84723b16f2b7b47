#include <spdlog/spdlog.h>

#include <algorithm>

#include "common/runtime/logger_lead.hpp"
#include "common/runtime/tick_master.hpp"
#include "common/runtime/tick_masters.hpp"

// What a tick master waits for (peers, the operator, commands, the wall clock, the logger), and
// what comes meanwhile.
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

safety::Offer offer_of(const scarab_JointCommand& command) {
  safety::Offer offer;
  offer.trial = command.header.trial;
  offer.tick = command.header.tick;
  offer.stop = command.kind == scarab_COMMAND_STOP;
  std::copy(std::begin(command.position_rad), std::end(command.position_rad),
            offer.position_rad.begin());
  return offer;
}

}  // namespace

void TickMaster::await_start() {
  status_.set_health(scarab_HEALTH_OK);
  const auto since = Clock::now();
  for (;;) {
    look_after_body();
    if (body_needs().empty()) status_.set_ready(trial_);
    const auto unmet = unmet_needs();
    if (unmet.empty()) break;
    if (Clock::now() - since > options_.report_silence) {
      status_.set_health(scarab_HEALTH_WAITING, "waits for " + join(unmet));
    }
    wait(kPoll);
  }
  status_.set_health(scarab_HEALTH_OK);
}

std::vector<std::string> TickMaster::unmet_needs() const {
  std::vector<std::string> unmet = body_needs();
  for (const auto& need : peers_.unmet()) unmet.push_back(need);
  for (const auto& name : board_.missing(expect_, trial_)) unmet.push_back(name + " to be ready");
  for (const auto& [peer, report] : board_.reports()) {
    const bool gone = report.lifecycle == scarab_LIFECYCLE_FINALISED;
    if (is_tick_master(peer) && peer != self_ && !gone) {
      unmet.push_back("no other tick master (found " + bus::to_string(peer) + ")");
    }
  }
  return unmet;
}

void TickMaster::hold_if_paused() {
  if (!desk_.paused()) return;
  flush();
  status_.set_health(scarab_HEALTH_WAITING, "paused by the operator");
  while (desk_.paused() && !body_.verdict()) {
    wait(real_time() ? sample_period() : kPausePoll);
    if (!real_time()) continue;
    scarab_RobotState unseen{};  // the motors are on, and their device wants to be talked to
    observe(unseen);
  }
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
    flush();
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

/// Real time: the gate's safe stop takes over from too many stale commands.
void TickMaster::await_command_until(TickPacer::TimePoint deadline) {
  for (auto left = deadline - Clock::now(); !answered_ && left.count() > 0;
       left = deadline - Clock::now()) {
    wait(left);
  }
}

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

/// Keeps the lead over every expected logger small; gives up on one that does not come on.
void TickMaster::await_logger() {
  if (options_.pace != Pace::kLockstep) return;
  const std::uint32_t lead = lead_over_logger(options_.samples_per_tick);
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
    const std::string reason =
        what + " for " + std::to_string(options_.give_up.count()) + " s" + why;
    body_.end({false, reason});
    status_.set_health(scarab_HEALTH_FAULT, reason);
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

void TickMaster::take_trials() {
  const auto newest = pending_ ? pending_->header.trial : trial_;
  trials_.take([&](const scarab_Trial& trial) {
    if (trial.header.trial > newest) pending_ = trial;
  });
  if (pending_ && stage_ != Stage::kIdle) throw Interrupted{};
}

/// All at once, but for a reset in the middle of the body's move: it waits for the next tick.
void TickMaster::take_operator() {
  const auto requests = desk_.update();
  if (desk_.stamp_ns() != 0) {
    status_.set_counter(kOperatorStamp, static_cast<std::uint64_t>(desk_.stamp_ns()));
  }
  if (requests.emergency_stop) {
    guarded_.emergency_stop(*requests.emergency_stop);
    reset_asked_ = false;
    report_gate();
  }
  if (requests.stop && stage_ == Stage::kRunning && !body_.verdict()) {
    guarded_.end({false, *requests.stop});
    show_lifecycle();
  }
  reset_asked_ = reset_asked_ || requests.reset;
  if (!moving_) reset_if_asked();
}

void TickMaster::take_commands() {
  behaviours_.take([this](const scarab_Behaviour& behaviour) {
    if (behaviour.header.trial == trial_) behaviour_tick_ = behaviour.header.tick;
  });
  commands_.take([this](const scarab_JointCommand& command) {
    const auto verdict = gate_.offer(offer_of(command));
    if (verdict.answers && !answered_) timing_.answered(Clock::now(), deadline_over_);
    answered_ = answered_ || verdict.answers;
    if (!verdict.fault.empty()) status_.set_health(scarab_HEALTH_DEGRADED, verdict.fault);
  });
}

std::string TickMaster::who_is_silent() const {
  return behaviour_tick_ >= static_cast<std::int64_t>(tick_) ? "premotor" : "supervisor";
}

}  // namespace scarab::runtime
