#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "common/robot/joints.hpp"
#include "common/robot/robot_model.hpp"
#include "services/premotor/core/motor_map.hpp"
#include "services/premotor/core/premotor_config.hpp"
#include "services/premotor/core/premotor_network.hpp"

namespace scarab::premotor {

/// What the supervisor asks of the network for one tick.
struct MotorIntent {
  bool stop = false;               ///< hold; the network still runs
  std::array<double, 4> inputs{};  ///< I1..I4
  std::optional<std::array<double, 3>>
      hind_pose_rad;  ///< T, C, F of both hind legs, in place of their motor neurons
  double backbone_rad = 0;
};

/// The whole premotor controller as a pure function from (state, intent) to (state, targets).
class PremotorController {
 public:
  /// Throws std::invalid_argument, saying what and where, for a number that is not finite, a delay
  /// outside 0..8 ticks or an empty joint range.
  PremotorController(const PremotorConfig& config, const robot::RobotModel& robot);

  /// The network's state at tick -1: all neurons silent but the CPG, started at
  /// config.network.cpg.start_output turned by a phase that depends on `seed` alone (0 if
  /// !random_phase), then run for config.start.warmup_ticks with config.start.warmup_inputs
  /// (backward walking).
  [[nodiscard]] NetworkState initial_state(std::uint64_t seed, bool random_phase) const;

  /// One synchronous update of all neurons. intent.stop makes no difference to it.
  [[nodiscard]] NetworkState step(const NetworkState& state, const MotorIntent& intent) const;

  /// Joint targets (rad, joint slots) of a state: gains, offsets and clipping to the joint ranges.
  [[nodiscard]] robot::JointVector targets(const NetworkState& state,
                                           const MotorIntent& intent) const;

  [[nodiscard]] const PremotorNetwork& network() const { return network_; }

 private:
  CpgConfig cpg_;
  StartConfig start_;
  PremotorNetwork network_;
  MotorMap motor_map_;
};

}  // namespace scarab::premotor
