#include "services/premotor/core/premotor_controller.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <stdexcept>

#include "tests/unit/premotor/f2_config.hpp"
#include "tests/unit/premotor/rhythm.hpp"

namespace scarab::premotor {
namespace {

PremotorController f2_controller() { return {f2_config(), beetle()}; }

bool same_bits(const NetworkState& a, const NetworkState& b) {
  return std::memcmp(&a, &b, sizeof(a)) == 0;
}

/// The intents of a trial: backward walking, soft pushing from tick 40, hard pushing from tick 90.
MotorIntent intent_at(int tick) {
  return {false,
          action(tick < 40   ? "backward"
                 : tick < 90 ? "soft_push"
                             : "hard_push")
              .inputs,
          {},
          0.05};
}

TEST(PremotorController, GoesOnFromACopiedStateBitByBit) {
  const PremotorController uninterrupted = f2_controller();
  NetworkState state = uninterrupted.initial_state(7, true);
  for (int stop = 0; stop < 140; ++stop) {
    std::array<unsigned char, sizeof(NetworkState)> file{};
    std::memcpy(file.data(), &state, sizeof(state));
    NetworkState restored;
    std::memcpy(static_cast<void*>(&restored), file.data(), sizeof(restored));
    const PremotorController restarted = f2_controller();

    state = uninterrupted.step(state, intent_at(stop));
    restored = restarted.step(restored, intent_at(stop));
    ASSERT_TRUE(same_bits(state, restored)) << "restarted before tick " << stop;
    ASSERT_EQ(uninterrupted.targets(state, intent_at(stop)),
              restarted.targets(restored, intent_at(stop)));
  }
}

TEST(PremotorController, TheStateIsNothingButTheOutputs) {
  // A state of which any one neuron is disturbed goes on differently, or the neuron has no synapse:
  // nothing is hidden elsewhere.
  const PremotorController controller = f2_controller();
  const NetworkState state = controller.initial_state(1, false);
  const NetworkState next = controller.step(state, intent_at(0));
  NetworkState disturbed = state;
  disturbed.psn1[12] += 0.1;
  EXPECT_FALSE(same_bits(controller.step(disturbed, intent_at(0)), next));
  disturbed = state;
  disturbed.motor[0] += 0.1;
  EXPECT_TRUE(same_bits(controller.step(disturbed, intent_at(0)), next))
      << "motor neurons feed nothing back";
}

TEST(PremotorController, StartPhaseDependsOnTheSeedAlone) {
  const PremotorController controller = f2_controller();
  EXPECT_TRUE(same_bits(controller.initial_state(3, true), controller.initial_state(3, true)));
  EXPECT_FALSE(same_bits(controller.initial_state(3, true), controller.initial_state(4, true)));
  EXPECT_TRUE(same_bits(controller.initial_state(3, false), controller.initial_state(4, false)));
}

TEST(PremotorController, StartPhasesCoverTheCircle) {
  const PremotorController controller = f2_controller();
  std::set<int> octants;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const auto [c1, c2] = controller.initial_state(seed, true).cpg;
    EXPECT_GT(std::hypot(c1, c2), 0.5) << "warmed up onto the orbit";
    octants.insert(static_cast<int>(std::floor(std::atan2(c2, c1) / 0.7853981633974484)));
  }
  EXPECT_EQ(octants.size(), 8U);
}

TEST(PremotorController, IsWarmAtTheStart) {
  const PremotorController controller = f2_controller();
  NetworkState state = controller.initial_state(0, false);
  double t_low = 0;
  double t_high = 0;
  for (int i = 0; i < 15; ++i) {
    state = controller.step(state, intent_at(0));
    t_low = std::min(t_low, state.motor[0]);
    t_high = std::max(t_high, state.motor[0]);
  }
  EXPECT_GT(t_high - t_low, 0.45) << "the first period has the full amplitude in the last layer";
}

TEST(PremotorController, WithoutWarmUpStartsFromTheConfiguredOutputs) {
  PremotorConfig config = f2_config();
  config.start.warmup_ticks = 0;
  const NetworkState state = PremotorController(config, beetle()).initial_state(0, false);
  EXPECT_EQ(state.cpg, config.network.cpg.start_output);
  EXPECT_EQ(state.input, config.start.warmup_inputs);
  EXPECT_EQ(state.motor, robot::JointVector{});
}

TEST(PremotorController, RunsOnWhileStopped) {
  const PremotorController controller = f2_controller();
  const NetworkState state = controller.initial_state(0, false);
  MotorIntent stopped = intent_at(0);
  stopped.stop = true;
  EXPECT_TRUE(same_bits(controller.step(state, stopped), controller.step(state, intent_at(0))));
}

TEST(PremotorController, RefusesNumbersThatAreNotFinite) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  PremotorConfig config = f2_config();
  config.network.cpg.start_output[1] = kNan;
  EXPECT_THROW(PremotorController(config, beetle()), std::invalid_argument);
  config = f2_config();
  config.start.warmup_inputs[0] = kNan;
  EXPECT_THROW(PremotorController(config, beetle()), std::invalid_argument);
  config = f2_config();
  config.network.psn.gate_weight = kNan;
  EXPECT_THROW(PremotorController(config, beetle()), std::invalid_argument);
}

}  // namespace
}  // namespace scarab::premotor
