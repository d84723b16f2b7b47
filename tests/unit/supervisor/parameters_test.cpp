#include <gtest/gtest.h>

#include <cmath>

#include "services/premotor/config.hpp"
#include "services/premotor/core/premotor_network.hpp"
#include "tests/unit/supervisor/scripted_robot.hpp"

// What the two shipped parameter files must agree on: the supervisor knows nothing of the network
// but these numbers.
namespace scarab::supervisor {
namespace {

premotor::PremotorConfig premotor_config() {
  return premotor::load_config(SCARAB_SOURCE_DIR "/config/premotor/beetle.yaml");
}

TEST(Parameters, AsIsAveragedOverTheCpgsPeriod) {
  constexpr double kTwoPi = 6.283185307179586476925;
  constexpr int kTicks = 20000;
  const premotor::PremotorConfig config = premotor_config();
  const premotor::PremotorNetwork network(config.network);
  premotor::NetworkState state;
  state.cpg = config.network.cpg.start_output;
  double turned = 0;
  for (int i = 0; i < kTicks; ++i) {
    const double before = std::atan2(state.cpg[1], state.cpg[0]);
    state = network.step(state, {0, 1, 0, 0});
    turned += std::remainder(std::atan2(state.cpg[1], state.cpg[0]) - before, kTwoPi);
  }
  const double period_ticks = kTwoPi * kTicks / std::abs(turned);
  EXPECT_NEAR(shipped_config().as.window_ticks, period_ticks, 0.02);
}

TEST(Parameters, AsIsComparedWithTheAngleTheFrontLegsAreToldToHold) {
  EXPECT_EQ(shipped_config().as.reference_rad, premotor_config().motor.front.f_offset_rad);
}

TEST(Parameters, TheTrialStartsInTheModeThatTheNetworkWasWarmedUpWith) {
  EXPECT_EQ(shipped_config().inputs.backward, premotor_config().start.warmup_inputs);
}

}  // namespace
}  // namespace scarab::supervisor
