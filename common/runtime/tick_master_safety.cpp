#include <spdlog/spdlog.h>

#include <utility>

#include "common/bus/clock.hpp"
#include "common/runtime/tick_master.hpp"

// A tick master's care for its body: the device between trials, the way home, faults, the gate.
namespace scarab::runtime {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kIdlePoll{200};
constexpr const char* kHoming = "homing: the joints go slowly to the start pose";

}  // namespace

/// Between trials.
void TickMaster::idle() {
  wait(real_time() ? sample_period() : kIdlePoll);
  look_after_body();
  const auto needs = body_needs();
  const auto health = status_.health();
  if (!needs.empty() && (health == scarab_HEALTH_OK || health == scarab_HEALTH_WAITING)) {
    status_.set_health(scarab_HEALTH_WAITING, "waits for " + join(needs));
  } else if (needs.empty() && health == scarab_HEALTH_WAITING) {
    status_.set_health(scarab_HEALTH_OK);
  }
}

/// While no trial runs: once a sensor period.
void TickMaster::look_after_body() {
  if (Clock::now() < idle_due_) return;
  idle_due_ = Clock::now() + sample_period();
  if (guarded_.idle()) publish_idle_state();
  body_.report(status_);
  show_lifecycle();
}

void TickMaster::publish_idle_state() {
  scarab_RobotState state{};
  if (!guarded_.observe(state)) return;
  state.header = {0, 0, 0, bus::now_ns()};
  state.phase = gate_.in_safe_stop() ? scarab_PHASE_SAFE_STOP : scarab_PHASE_RUNNING;
  state.real_time = real_time();
  sensors_.write(state);
}

/// What no trial can start without, each as the end of "waits for ...".
std::vector<std::string> TickMaster::body_needs() const {
  if (!body_.configured()) return {body_.waiting_for()};
  if (const auto fault = guarded_.fault()) return {"the end of a fault: " + *fault};
  return {};
}

/// From where the robot stands to the start pose, before the first tick: nobody is asked yet. A
/// safe stop on the way is a matter of the ticks, like any other.
void TickMaster::go_home() {
  pacer_.restart(Clock::now());
  while (gate_.homing() && !gate_.in_safe_stop() && !body_.verdict()) {
    hold_if_paused();
    status_.set_health(scarab_HEALTH_WAITING, kHoming);
    publish_state(true);
    status_.set_progress(header());
    gate_.advance_homing();
    if (gate_.homing()) move_body();
    flush();
    desk_.tick_started();
  }
  if (status_.health() == scarab_HEALTH_WAITING) status_.set_health(scarab_HEALTH_OK);
}

/// What the robot's sensors read; a fault that shows in it has brought the safe stop.
void TickMaster::observe(scarab_RobotState& state) {
  const bool held = gate_.in_safe_stop();
  guarded_.observe(state);
  if (gate_.in_safe_stop() != held) report_gate();
}

void TickMaster::reset_if_asked() {
  if (!std::exchange(reset_asked_, false)) return;
  reset_refusal_ = guarded_.reset().value_or("");
  report_gate();
}

/// What has no motors to switch off stays active until the trial's last answer.
void TickMaster::rest() {
  guarded_.rest();
  if (!body_.powered()) show_lifecycle();
}

/// Active: a trial runs, with the motors on and nothing that forbids it. A device that is lost in a
/// trial, and a safe stop without torque, leave it inactive.
void TickMaster::show_lifecycle() {
  const bool runs = stage_ == Stage::kRunning;
  status_.set_lifecycle(runs && guarded_.active()    ? scarab_LIFECYCLE_ACTIVE
                        : runs || body_.configured() ? scarab_LIFECYCLE_INACTIVE
                                                     : scarab_LIFECYCLE_UNCONFIGURED);
}

/// What the gate refuses and why it holds the robot, if it does.
void TickMaster::report_gate() {
  show_lifecycle();
  for (const auto& [name, value] : gate_.counters().named()) status_.set_counter(name, value);
  const bool homing = gate_.homing() && stage_ == Stage::kRunning;
  if (gate_.in_safe_stop()) {
    const std::string refused = reset_refusal_.empty() ? "" : "; reset refused: " + reset_refusal_;
    status_.set_health(scarab_HEALTH_DEGRADED, "safe stop: " + gate_.safe_stop_reason() + refused);
  } else if (homing) {
    status_.set_health(scarab_HEALTH_DEGRADED,
                       std::string(kHoming) + ", commands do not count yet");
  } else if (gate_holds_) {
    status_.set_health(scarab_HEALTH_OK);
  }
  gate_holds_ = gate_.in_safe_stop() || homing;
}

}  // namespace scarab::runtime
