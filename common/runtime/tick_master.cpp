#include "common/runtime/tick_master.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>

#include "common/bus/clock.hpp"

namespace scarab::runtime {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kIdlePoll{200};

safety::Offer offer_of(const scarab_JointCommand& command) {
  safety::Offer offer;
  offer.trial = command.header.trial;
  offer.tick = command.header.tick;
  offer.stop = command.kind == scarab_COMMAND_STOP;
  std::copy(std::begin(command.position_rad), std::end(command.position_rad),
            offer.position_rad.begin());
  return offer;
}

Expectation without(Expectation expect, const std::string& service) {
  expect.erase(service);
  return expect;
}

}  // namespace

TickMaster::TickMaster(bus::Participant& participant, const ServiceOptions& service,
                       const bus::Peer& self, const TickMasterOptions& options, TickBody& body,
                       safety::CommandGate& gate)
    : options_(options),
      body_(body),
      gate_(gate),
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
  status_.set_lifecycle(scarab_LIFECYCLE_INACTIVE);
}

void TickMaster::run() {
  if (real_time()) take_care_of_real_time(status_);
  status_.publish_if_due();
  while (!shutdown_.requested()) {
    try {
      if (!pending_) wait(kIdlePoll);
      if (pending_) run_trial();
    } catch (const Interrupted&) {
      if (status_.lifecycle() == scarab_LIFECYCLE_ACTIVE) {
        spdlog::warn("trial {} left at tick {}", trial_, tick_);
        gate_.end_trial();
        status_.set_lifecycle(scarab_LIFECYCLE_INACTIVE);
      }
    }
  }
  status_.set_lifecycle(scarab_LIFECYCLE_FINALISED);
  status_.publish_if_due();
}

void TickMaster::run_trial() {
  const scarab_Trial trial = *pending_;
  pending_.reset();
  trial_ = trial.header.trial;
  tick_ = 0;
  behaviour_tick_ = -1;
  try {
    body_.begin(trial);
  } catch (const std::exception& error) {
    status_.set_health(scarab_HEALTH_FAULT,
                       "trial " + std::to_string(trial_) + ": " + error.what());
    status_.publish_if_due();
    return;
  }
  gate_.begin_trial(trial_, body_.held_rad(), body_.home_rad());
  desk_.begin_trial();
  await_start();
  pacer_.restart(Clock::now());
  while (run_tick()) ++tick_;
  finish();
}

/// One tick of the chain; false after the trial's last.
bool TickMaster::run_tick() {
  hold_if_paused();
  gate_.expect(tick_);
  answered_ = false;
  deadline_over_ = false;
  const bool last = body_.verdict().has_value();
  timing_.asked(Clock::now());
  if (real_time()) pacer_.tick_begins(Clock::now());
  publish_state(false);
  if (last || !real_time()) {
    await_command();
  } else {
    await_until(
        std::min(pacer_.end(), pacer_.due() + options_.tick_period / options_.samples_per_tick));
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
  body_.advance(target_rad, [&] {
    if (real_time()) {
      await_until(pacer_.due() + ++sample * (options_.tick_period / options_.samples_per_tick));
    }
    publish_state(true);
  });
  if (!real_time()) return;
  pacer_.tick_ends(Clock::now());
  await_until(pacer_.due());
}

void TickMaster::publish_state(bool between_ticks) {
  scarab_RobotState state{};
  state.header = header();
  state.phase = phase();
  state.real_time = real_time();
  body_.observe(state);
  if (between_ticks) {
    sensors_.stage(state);
  } else {
    states_.write(state);
  }
  body_.publish_own(state.header);
  // In lockstep nobody is in a hurry for the samples between ticks: they leave in a few packets
  // while the chain works on the tick.
  if (!between_ticks || real_time()) flush();
  if (!between_ticks) {
    status_.set_progress(state.header);
    report_gate();
    timing_.report(pacer_, status_);
  }
}

/// Sends the samples between ticks.
void TickMaster::flush() {
  sensors_.flush();
  body_.flush_own();
}

void TickMaster::take_trials() {
  const auto newest = pending_ ? pending_->header.trial : trial_;
  trials_.take([&](const scarab_Trial& trial) {
    if (trial.header.trial > newest) pending_ = trial;
  });
  const bool in_trial = status_.lifecycle() == scarab_LIFECYCLE_ACTIVE;
  if (pending_ && in_trial) throw Interrupted{};
}

void TickMaster::take_operator() {
  const auto requests = desk_.update();
  if (desk_.stamp_ns() != 0) {
    status_.set_counter(kOperatorStamp, static_cast<std::uint64_t>(desk_.stamp_ns()));
  }
  const bool in_trial = status_.lifecycle() == scarab_LIFECYCLE_ACTIVE;
  if (requests.stop && in_trial && !body_.verdict()) body_.end({false, *requests.stop});
  if (requests.emergency_stop) gate_.emergency_stop(*requests.emergency_stop);
  if (requests.reset) gate_.reset(gate_.target_rad());
  if (requests.emergency_stop || requests.reset) report_gate();
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

void TickMaster::finish() {
  const auto end = body_.verdict();
  spdlog::info("trial {} ends at tick {}: {}: {}", trial_, tick_,
               end && end->success ? "success" : "failure", end ? end->reason : "");
  gate_.end_trial();
  status_.set_lifecycle(scarab_LIFECYCLE_INACTIVE);
  status_.publish_if_due();
}

scarab_Header TickMaster::header() const { return {trial_, tick_, body_.time_ns(), bus::now_ns()}; }

scarab_TrialPhase TickMaster::phase() const {
  if (const auto end = body_.verdict()) {
    return end->success ? scarab_PHASE_SUCCEEDED : scarab_PHASE_FAILED;
  }
  if (gate_.in_safe_stop()) return scarab_PHASE_SAFE_STOP;
  return gate_.homing() ? scarab_PHASE_HOMING : scarab_PHASE_RUNNING;
}

/// What the gate refuses and why it holds the robot, if it does.
void TickMaster::report_gate() {
  for (const auto& [name, value] : gate_.counters().named()) status_.set_counter(name, value);
  const bool homing = gate_.homing() && status_.lifecycle() == scarab_LIFECYCLE_ACTIVE;
  if (gate_.in_safe_stop()) {
    status_.set_health(scarab_HEALTH_DEGRADED, "safe stop: " + gate_.safe_stop_reason());
  } else if (homing) {
    status_.set_health(scarab_HEALTH_DEGRADED,
                       "homing: the joints go slowly to the start pose, commands do not count yet");
  } else if (gate_holds_) {
    status_.set_health(scarab_HEALTH_OK);
  }
  gate_holds_ = gate_.in_safe_stop() || homing;
}

}  // namespace scarab::runtime
