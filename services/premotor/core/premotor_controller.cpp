#include "services/premotor/core/premotor_controller.hpp"

#include <cmath>
#include <stdexcept>

#include "common/random/random.hpp"

namespace scarab::premotor {
namespace {

constexpr double kTwoPi = 6.283185307179586476925;
constexpr std::uint64_t kStartPhase = random::stream("cpg start phase");

void require_finite(const PremotorConfig& config) {
  for (const double output : config.network.cpg.start_output) {
    if (!std::isfinite(output)) {
      throw std::invalid_argument("start output of the CPG is not finite");
    }
  }
  for (const double input : config.start.warmup_inputs) {
    if (!std::isfinite(input)) {
      throw std::invalid_argument("warm-up inputs are not finite");
    }
  }
}

}  // namespace

PremotorController::PremotorController(const PremotorConfig& config, const robot::RobotModel& robot)
    : cpg_(config.network.cpg),
      start_(config.start),
      network_(config.network),
      motor_map_(config.motor, robot) {
  require_finite(config);
}

NetworkState PremotorController::initial_state(std::uint64_t seed, bool random_phase) const {
  const double phase_rad = random_phase ? kTwoPi * random::uniform(seed, kStartPhase, 0) : 0;
  const auto [c1, c2] = cpg_.start_output;
  NetworkState state;
  state.input = start_.warmup_inputs;
  state.cpg = {c1 * std::cos(phase_rad) - c2 * std::sin(phase_rad),
               c1 * std::sin(phase_rad) + c2 * std::cos(phase_rad)};
  for (unsigned tick = 0; tick < start_.warmup_ticks; ++tick) {
    state = network_.step(state, start_.warmup_inputs);
  }
  return state;
}

NetworkState PremotorController::step(const NetworkState& state, const MotorIntent& intent) const {
  return network_.step(state, intent.inputs);
}

robot::JointVector PremotorController::targets(const NetworkState& state,
                                               const MotorIntent& intent) const {
  return motor_map_.targets(state, intent.hind_pose_rad, intent.backbone_rad);
}

}  // namespace scarab::premotor
