#include "common/runtime/tick_master.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

#include "common/bus/clock.hpp"
#include "common/runtime/end_words.hpp"

namespace scarab::runtime {
namespace {

using Clock = std::chrono::steady_clock;

Expectation without(Expectation expect, const std::string& service) {
  expect.erase(service);
  return expect;
}

}  // namespace

TickMaster::TickMaster(bus::Participant& participant, const ServiceOptions& service,
                       const bus::Peer& self, const TickMasterOptions& options, TickBody& body,
                       safety::CommandGate& gate)
    : options_(options),
      self_(self),
      body_(body),
      gate_(gate),
      guarded_(body, gate, options.pace == Pace::kRealTime ? OnThrow::kSafeStop : OnThrow::kPassOn),
      expect_(without(service.expect, self.service)),
      peers_(expect_),
      guard_(participant),
      wait_set_(participant),
      trials_(participant, bus::kTrial),
      commands_(participant, bus::kJointCommand),
      behaviours_(participant, bus::kBehaviour),
      board_(participant),
      desk_(participant),
      states_(participant, bus::kRobotState),
      sensors_(participant, bus::kRobotSensors),
      status_(participant, self),
      shutdown_(guard_),
      pacer_(options.tick_period),
      timing_(options.pace == Pace::kRealTime) {
  wait_set_.attach(trials_);
  wait_set_.attach(commands_);
  wait_set_.attach(board_.reader());
  wait_set_.attach(desk_.reader());
  wait_set_.attach(guard_);
  peers_.need(states_, "supervisor");
  peers_.need(states_, "logger");
  peers_.need(sensors_, "logger");
  peers_.need(commands_, "premotor");
  body_.add_needs(peers_);
  show_lifecycle();
}

void TickMaster::run() {
  if (real_time()) take_care_of_real_time(status_);
  status_.publish_if_due();
  while (!shutdown_.requested()) {
    try {
      if (!pending_) idle();
      if (pending_) run_trial();
    } catch (const Interrupted&) {
      leave_trial();
    } catch (const BodyFailure& failure) {
      leave_trial();
      fail_trial(failure.what());
    }
  }
  guarded_.rest();
  status_.set_lifecycle(scarab_LIFECYCLE_FINALISED);
  status_.publish_if_due();
}

void TickMaster::run_trial() {
  const scarab_Trial trial = *pending_;
  pending_.reset();
  stage_ = Stage::kStarting;
  trial_ = trial.header.trial;
  tick_ = 0;
  behaviour_tick_ = -1;
  if (!succeeds([&] { body_.begin(trial); })) return;
  desk_.begin_trial();
  await_start();
  if (!succeeds([&] { guarded_.begin_trial(trial_); })) return;
  stage_ = Stage::kRunning;
  show_lifecycle();
  spdlog::info("trial {} starts", trial_);
  go_home();
  body_.start();
  pacer_.restart(Clock::now());
  while (run_tick()) ++tick_;
  finish();
}

/// Whether the trial can be begun as far as `step` goes; where that throws it is refused.
bool TickMaster::succeeds(const std::function<void()>& step) {
  try {
    step();
    return true;
  } catch (const std::exception& error) {
    end_trial();
    fail_trial(error.what());
    return false;
  }
}

/// One tick of the chain; false after the trial's last.
bool TickMaster::run_tick() {
  hold_if_paused();
  reset_if_asked();
  guarded_.expect(tick_);
  answered_ = false;
  deadline_over_ = false;
  timing_.asked(Clock::now());
  if (real_time()) pacer_.tick_begins(Clock::now());
  const scarab_TrialPhase announced = publish_state(false);
  const bool last = announced == scarab_PHASE_SUCCEEDED || announced == scarab_PHASE_FAILED;
  if (last) rest();  // the last answer moves nothing
  if (last || !real_time()) {
    await_command();
  } else {
    await_command_until(std::min(pacer_.end(), pacer_.due() + sample_period()));
  }
  if (last || (!answered_ && !real_time())) return false;
  await_logger();
  move_body();
  desk_.tick_started();
  return true;
}

/// For one tick towards what the gate allows. In real time each sensor sample has its time.
void TickMaster::move_body() {
  const robot::JointVector target_rad = gate_.target_rad();
  deadline_over_ = real_time();
  unsigned sample = 0;
  moving_ = true;
  guarded_.advance(target_rad, [&] {
    if (real_time()) await_until(pacer_.due() + ++sample * sample_period());
    publish_state(true);
  });
  moving_ = false;
  if (!real_time()) return;
  pacer_.tick_ends(Clock::now());
  await_until(pacer_.due());
}

/// The phase it announces.
scarab_TrialPhase TickMaster::publish_state(bool between_ticks) {
  scarab_RobotState state{};
  observe(state);
  state.header = header();
  state.phase = phase();
  state.real_time = real_time();
  if (between_ticks) {
    between_ticks_.push_back(state);
  } else {
    states_.write(state);
  }
  body_.publish_own(state.header);
  // In lockstep nobody is in a hurry for the samples between ticks: all that their writing costs is
  // paid while the chain works on the tick, and they leave in a few packets.
  if (real_time() || !between_ticks) flush();
  if (!between_ticks) {
    status_.set_progress(state.header);
    report_gate();
    timing_.report(pacer_, status_);
    body_.report(status_);
  }
  return state.phase;
}

/// Sends the samples between ticks.
void TickMaster::flush() {
  for (const scarab_RobotState& state : between_ticks_) sensors_.stage(state);
  between_ticks_.clear();
  sensors_.flush();
  body_.flush_own();
}

void TickMaster::finish() {
  const std::string ended = end_words(trial_, body_.verdict().value_or(TrialEnd{}));
  spdlog::info("{} (at tick {})", ended, tick_);
  end_trial();
  if (options_.tells_end) {
    const std::string before = status_.message();
    status_.set_health(status_.health(), before.empty() ? ended : before + "; " + ended);
  }
  status_.publish_if_due();
}

void TickMaster::leave_trial() {
  if (stage_ == Stage::kIdle) return;
  if (stage_ == Stage::kRunning) spdlog::warn("trial {} left at tick {}", trial_, tick_);
  if (status_.health() == scarab_HEALTH_WAITING) status_.set_health(scarab_HEALTH_OK);
  end_trial();
}

/// No verdict comes of it.
void TickMaster::fail_trial(const std::string& why) {
  status_.set_health(scarab_HEALTH_FAULT, "trial " + std::to_string(trial_) + ": " + why);
  status_.publish_if_due();
}

void TickMaster::end_trial() {
  guarded_.end_trial();  // the motors first
  flush();
  moving_ = false;
  stage_ = Stage::kIdle;
  show_lifecycle();
}

scarab_Header TickMaster::header() const { return {trial_, tick_, body_.time_ns(), bus::now_ns()}; }

scarab_TrialPhase TickMaster::phase() const {
  if (const auto end = body_.verdict()) {
    return end->success ? scarab_PHASE_SUCCEEDED : scarab_PHASE_FAILED;
  }
  if (gate_.in_safe_stop()) return scarab_PHASE_SAFE_STOP;
  return gate_.homing() ? scarab_PHASE_HOMING : scarab_PHASE_RUNNING;
}

}  // namespace scarab::runtime
