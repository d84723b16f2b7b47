#pragma once

#include <cstdint>
#include <deque>

#include "common/robot/joints.hpp"
#include "services/plant/core/sensor_config.hpp"

namespace scarab::plant {

/// The way of the commands to the servos. Command k, sent at step s, takes effect from step
///
///     s + latency + floor(u_k (jitter + 1)),   u_k uniform in [0, 1), all in physics steps,
///
/// a pure function of (seed, k). A command that arrives together with a later one, or after it, is
/// overtaken and never takes effect: servos do not go back to an older target.
class CommandDelay {
 public:
  /// `initial_rad` holds until the first command arrives. Throws std::invalid_argument for times
  /// that are no whole numbers of steps.
  CommandDelay(const CommandPathConfig& config, std::uint64_t seed, std::int64_t step_ns,
               const robot::JointVector& initial_rad);

  /// Command `k` is sent before step `step`; both grow from call to call.
  void send(std::uint64_t k, std::int64_t step, const robot::JointVector& target_rad);

  /// The target that the servos follow in step `step`; steps are asked for in order.
  [[nodiscard]] const robot::JointVector& arrived_at(std::int64_t step);

 private:
  struct Sent {
    std::int64_t arrival_step;
    robot::JointVector target_rad;
  };

  std::uint64_t seed_;
  std::int64_t latency_steps_;
  std::int64_t jitter_steps_;
  std::deque<Sent> under_way_;  // in the order of arrival
  robot::JointVector target_rad_;
};

}  // namespace scarab::plant
