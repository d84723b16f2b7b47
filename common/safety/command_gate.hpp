#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "common/robot/joints.hpp"
#include "common/robot/robot_model.hpp"
#include "common/safety/gate_counters.hpp"
#include "common/safety/target_limiter.hpp"
#include "common/safety/verdict.hpp"

namespace scarab::safety {

struct GateOptions {
  double tick_period_s = 0.1;
  double homing_velocity_rad_s = 0.5;  ///< limit of each joint on its way to the start pose
  /// So many ticks in a row without a standing answer bring the safe stop: the real-time mode,
  /// where a command older than this is stale. 0: never, the lockstep mode, where the tick master
  /// waits instead.
  std::uint32_t stale_ticks_limit = 0;
};

/// A command as it came from the bus.
struct Offer {
  std::uint32_t trial = 0;
  std::uint32_t tick = 0;
  bool stop = false;  ///< hold the present targets; position_rad is ignored
  robot::JointVector position_rad{};
};

/// The only way from a command to a servo, the same for the simulated plant and a real robot:
/// decides which command answers a tick, and moves the targets no further than range, torque and
/// speed allow.
///
/// A trial is active between begin_trial() and end_trial(). For each tick the tick master calls
/// expect(), offers what arrives, and applies target_rad(). In safe stop the targets hold still,
/// whatever arrives; only reset() ends it, and then all joints go home, slowly and tick by tick,
/// before commands count again. So do those of a robot that does not stand at home when its trial
/// begins. An ended or a new trial does not end a safe stop.
class CommandGate {
 public:
  /// Throws std::invalid_argument if an option is not above 0 where it must be.
  CommandGate(const robot::RobotModel& robot, const GateOptions& options);
  CommandGate(const robot::RobotModel& robot, double tick_period_s)
      : CommandGate(robot, GateOptions{tick_period_s, GateOptions{}.homing_velocity_rad_s, 0}) {}

  /// `held_rad`: where the joints stand; `home_rad`: the trial's start pose, to which they go as
  /// far as their ranges let them, now and after a reset. Throws std::invalid_argument if one is
  /// not finite; then no trial is active.
  void begin_trial(std::uint32_t trial, const robot::JointVector& held_rad,
                   const robot::JointVector& home_rad);
  void end_trial() noexcept;

  /// The tick whose answer is wanted from now on; all earlier ones are over. Moves a homing on.
  void expect(std::uint32_t tick);
  /// Moves the targets of a homing by one tick, and ends it when they have been at home for a tick;
  /// nothing outside a homing or in safe stop. For the homing before the first tick.
  void advance_homing();
  /// Where the joints stand now (rad): lets the torque limit act on the next command. Only for
  /// servos that have no torque limit of their own.
  void observe(const robot::JointVector& measured_rad) { measured_rad_ = measured_rad; }
  Verdict offer(const Offer& offer);

  /// What to apply (rad, joint slots): always finite, 0 for absent joints.
  [[nodiscard]] const robot::JointVector& target_rad() const { return limiter_.target_rad(); }

  /// A person's. Its reason takes the place of that of a safe stop, not of an earlier emergency
  /// stop.
  void emergency_stop(std::string reason) noexcept;
  /// Something the robot or its device tells. The first reason of a safe stop stays.
  void safe_stop(std::string reason) noexcept;
  /// Ends the safe stop, however it came; then the joints go home from `held_rad`, where they
  /// stand. Throws std::invalid_argument if that is not finite: the safe stop stays.
  void reset(const robot::JointVector& held_rad);
  /// Targets hold still; a driver whose robot asks for it drops the torque meanwhile.
  [[nodiscard]] bool in_safe_stop() const noexcept { return safe_stop_; }
  [[nodiscard]] const std::string& safe_stop_reason() const noexcept { return safe_stop_reason_; }
  /// On the slow way home.
  [[nodiscard]] bool homing() const noexcept { return homing_; }

  [[nodiscard]] const GateCounters& counters() const noexcept { return counters_; }

 private:
  void hold(std::string reason) noexcept;
  Verdict judge(const Offer& offer);
  Verdict accept(const Offer& offer);
  [[nodiscard]] Verdict compare(const Offer& known, const Offer& offer) const;
  [[nodiscard]] std::optional<std::size_t> not_finite(const Offer& offer) const;
  [[nodiscard]] const Offer* remembered(std::uint32_t tick) const;

  robot::RobotModel robot_;
  GateOptions options_;
  TargetLimiter limiter_;
  GateCounters counters_;

  std::optional<std::uint32_t> trial_;     ///< while one is active
  std::optional<std::uint32_t> expected_;  ///< the tick that is asked
  bool answered_ = false;                  ///< the expected tick has its answer
  std::uint32_t stale_ticks_ = 0;          ///< in a row without an answer
  std::optional<robot::JointVector> measured_rad_;
  robot::JointVector home_rad_{};
  bool homing_ = false;
  bool safe_stop_ = false;
  bool emergency_ = false;  ///< the safe stop is an emergency stop
  std::string safe_stop_reason_;

  /// Answers to the newest ticks, by tick modulo the size: a replica's late answer is compared, not
  /// just refused. As many as the readers of the chain's topics keep.
  std::array<std::optional<Offer>, 64> answers_;
};

}  // namespace scarab::safety
