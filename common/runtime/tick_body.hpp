#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "common/bus/topics.hpp"
#include "common/robot/joints.hpp"
#include "common/runtime/peers.hpp"
#include "common/runtime/status_publisher.hpp"

namespace scarab::runtime {

/// How a trial ended.
struct TrialEnd {
  bool success = false;
  std::string reason;
};

/// What the tick master moves: the simulated plant, or a real robot behind its bridge.
///
/// A trial: begin(), configured() awaited, activate(), the homing (advance() as in a tick),
/// start(), tick after tick, rest(). What has a default leaves out what a simulated body has no use
/// for. The tick master has one thread, and calls all of this from it.
///
/// What observe(), advance() or idle() throws is a fault like one that fault() tells, until
/// observe() or idle() succeeds again; in lockstep, where nobody stands by, it ends the trial
/// without a verdict.
class TickBody {
 public:
  virtual ~TickBody() = default;

  // A trial, in the order of the calls.

  /// Makes ready for a trial and stands still; motors that are off stay off. Throws std::exception
  /// naming what of the trial cannot be done.
  virtual void begin(const scarab_Trial& trial) = 0;
  /// False while the device is not there: lifecycle unconfigured, and no trial starts.
  [[nodiscard]] virtual bool configured() const { return true; }
  /// What it waits for while it is not configured, as the end of "waits for ...".
  [[nodiscard]] virtual std::string waiting_for() const { return "its device"; }
  /// Motors on, holding where they stand. Everybody is ready, and the homing comes next; or a
  /// safe stop is being reset. Throws std::exception saying why not, and nothing is half on: the
  /// trial is refused, or the safe stop stays.
  virtual void activate() {}
  /// Where the joints stand now, as targets (rad): the last ones applied, or what is measured where
  /// motors were off since. Asked after activate().
  [[nodiscard]] virtual robot::JointVector held_rad() const = 0;
  /// Start pose of the trial, rad: where the homing goes.
  [[nodiscard]] virtual robot::JointVector home_rad() const = 0;
  /// The robot stands at home (or has been stopped on the way): the trial's time begins.
  virtual void start() {}
  /// Time since start(), ns; 0 before.
  [[nodiscard]] virtual std::int64_t time_ns() const = 0;
  /// What the robot's sensors read now; fills all but header and phase. Once a tick and once a
  /// sample, also in a safe stop and in a pause; in a trial it also looks after a lost device.
  virtual void observe(scarab_RobotState& state) = 0;
  /// Moves for one control tick towards `target_rad`; calls `sample` after each sensor period
  /// inside it, but for the one that ends the tick. `sample` waits for the time of the sample, and
  /// safe_stop() and end() may come in it; it may throw.
  virtual void advance(const robot::JointVector& target_rad,
                       const std::function<void()>& sample) = 0;
  /// The verdict on the trial; none while it is open.
  [[nodiscard]] virtual std::optional<TrialEnd> verdict() const = 0;
  /// Ends the trial from outside (operator, silence): the verdict from now on.
  virtual void end(const TrialEnd& end) = 0;
  /// Motors off: the trial has ended or was left, or the process ends. May come more than once.
  virtual void rest() noexcept {}

  // Safety.

  /// The gate has just begun a safe stop, or a person has ended the trial: called at once, also in
  /// the middle of a tick, before anything else is written. From now on no target is applied until
  /// activate(), whatever advance() says.
  virtual void safe_stop() noexcept {}
  /// Whether the motors have power: not before activate() or after rest(), and a safe stop may take
  /// it. What has no motors always has.
  [[nodiscard]] virtual bool powered() const noexcept { return true; }
  /// What of the body's own state forbids to go on (a lost device, heat, current, inclination), in
  /// words that stay the same while it lasts: it brings the safe stop for this reason, and keeps it
  /// from being reset and a trial from starting. Asked after each observe().
  [[nodiscard]] virtual std::optional<std::string> fault() const { return std::nullopt; }

  // Between trials, and while others are waited for.

  /// Looks after the device (connects, reads), once a sensor period. True: observe() has something
  /// to tell; it is published as robot_sensors of trial 0.
  virtual bool idle() { return false; }

  // What it says.

  /// Publishes what the body alone knows (the plant: world_state), at every tick and every sample;
  /// may wait for flush_own().
  virtual void publish_own(const scarab_Header& header) = 0;
  /// Sends what publish_own() has kept back.
  virtual void flush_own() = 0;
  /// Own counters and histograms, for service_status.
  virtual void report(StatusPublisher&) const {}
  /// Names the peers its own endpoints need before a trial starts.
  virtual void add_needs(PeerCheck& peers) const = 0;
};

}  // namespace scarab::runtime
