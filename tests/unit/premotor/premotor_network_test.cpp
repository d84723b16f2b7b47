#include "services/premotor/core/premotor_network.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "tests/unit/premotor/f2_config.hpp"
#include "tests/unit/premotor/rhythm.hpp"

namespace scarab::premotor {
namespace {

/// Name of the neuron behind a member of NetworkState.
std::string name_at(const PremotorNetwork& network, const NetworkState& state,
                    const double& member) {
  const auto* first =
      reinterpret_cast<const double*>(&state);  // NOLINT: the layout is what is tested
  return network.description().neurons()[static_cast<std::size_t>(&member - first)].name;
}

TEST(PremotorNetwork, NeuronsStandInTheOrderOfTheState) {
  const PremotorNetwork network(f2_config().network);
  const NetworkState state;
  ASSERT_EQ(network.description().size(), kNeuronCount);
  EXPECT_EQ(name_at(network, state, state.input[2]), "I3");
  EXPECT_EQ(name_at(network, state, state.cpg[1]), "CPG.C2");
  EXPECT_EQ(name_at(network, state, state.psn1[12]), "PSN1.P13");
  EXPECT_EQ(name_at(network, state, state.psn2[0]), "PSN2.P1");
  EXPECT_EQ(name_at(network, state, state.psn3[13]), "PSN3.P14");
  EXPECT_EQ(name_at(network, state, state.psn4[2]), "PSN4.P3");
  EXPECT_EQ(name_at(network, state, state.vrn1[6]), "VRN1.V7");
  EXPECT_EQ(name_at(network, state, state.vrn2[0]), "VRN2.V1");
  EXPECT_EQ(name_at(network, state, state.delay_line[7]), "DELAY.D8");
  for (std::size_t slot = 0; slot < robot::kJointCount; ++slot) {
    EXPECT_EQ(name_at(network, state, state.motor[slot]),
              "MN." + std::string(robot::kJointNames[slot]));
  }
}

TEST(PremotorNetwork, DrivesEveryJointOfATripodWithOneSign) {
  const Recording backward =
      record(PremotorController(f2_config(), beetle()), {false, {0, 1, 0, 0}, {}, 0});
  for (const NetworkState& state : backward.states) {
    for (const robot::Leg leg : robot::kLegs) {
      const robot::Leg reference = robot::row(leg) == 2 ? robot::Leg::kL2 : robot::Leg::kL0;
      for (const robot::LegJoint joint :
           {robot::LegJoint::kThoracoCoxal, robot::LegJoint::kCoxaTrochanteral}) {
        const double sign = robot::tripod_sign(leg) * robot::tripod_sign(reference);
        ASSERT_EQ(state.motor[joint_slot(leg, joint)],
                  sign * state.motor[joint_slot(reference, joint)]);
      }
      ASSERT_EQ(state.motor[joint_slot(leg, robot::LegJoint::kFemurTibia)], 0) << "held";
    }
  }
}

TEST(PremotorNetwork, BiasesTheSecondTripodAgainstTheFirst) {
  NetworkConfig config = f2_config().network;
  config.motor_bias = {0.1, 0.2, 0.3, 0.4};
  const PremotorNetwork network(config);
  const auto bias = [&](const char* name) {
    return network.description().neurons()[network.description().find(name)].bias;
  };
  EXPECT_EQ(bias("MN.TL0"), 0.1);
  EXPECT_EQ(bias("MN.TL1"), -0.1);
  EXPECT_EQ(bias("MN.CR0"), -0.2);
  EXPECT_EQ(bias("MN.CR1"), 0.2);
  EXPECT_EQ(bias("MN.TL2"), 0.3);
  EXPECT_EQ(bias("MN.CR2"), -0.4);
  EXPECT_EQ(bias("MN.FL0"), 0);
  EXPECT_EQ(bias("MN.BJ"), 0);
}

class Delay : public testing::TestWithParam<double> {};

// TL0 follows PSN3.P13 by the delay, CL0 follows PSN4.P13 without; the motor neuron's step is
// common to both.
TEST_P(Delay, HoldsBackTheTJointsByTau) {
  PremotorConfig config = f2_config();
  config.network.t_delay_ticks = GetParam();
  const Recording forward =
      record(PremotorController(config, beetle()), {false, {1, 1, 0, 0}, {}, 0});
  const auto whole = static_cast<std::size_t>(GetParam());
  const double fraction = GetParam() - static_cast<double>(whole);
  for (std::size_t t = 10; t < forward.states.size(); ++t) {
    const auto p13 = [&](std::size_t late) { return forward.states[t - 1 - late].psn3[12]; };
    const double expected =
        fraction == 0 ? p13(whole) : (1 - fraction) * p13(whole) + fraction * p13(whole + 1);
    const MotorBiasConfig& bias = config.network.motor_bias;
    ASSERT_NEAR(forward.states[t].motor[0], expected + bias.front_middle_t, 1e-15);
    ASSERT_NEAR(forward.states[t].motor[6], forward.states[t - 1].psn4[12] + bias.front_middle_c,
                1e-15);
  }
}

TEST_P(Delay, LeavesUnusedPlacesAtZero) {
  PremotorConfig config = f2_config();
  config.network.t_delay_ticks = GetParam();
  const Recording forward =
      record(PremotorController(config, beetle()), {false, {1, 1, 0, 0}, {}, 0}, 50);
  const auto used = static_cast<std::size_t>(std::ceil(GetParam()));
  for (std::size_t place = 0; place < 8; ++place) {
    const Signal output = signal(forward, [=](const auto& s) { return s.delay_line[place]; });
    EXPECT_EQ(swing_of(output) > 0.1, place < used) << "D" << place + 1;
  }
}

INSTANTIATE_TEST_SUITE_P(Tau, Delay, testing::Values(0.0, 0.5, 1.0, 2.0, 2.39, 7.25, 8.0));

TEST(PremotorNetwork, RefusesADelayThatTheLineCannotHold) {
  NetworkConfig config = f2_config().network;
  for (const double ticks : {-0.1, 8.01, std::numeric_limits<double>::quiet_NaN()}) {
    config.t_delay_ticks = ticks;
    EXPECT_THROW(PremotorNetwork{config}, std::invalid_argument) << ticks;
  }
}

TEST(PremotorNetwork, RefusesAWeightThatIsNotFinite) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [&](const auto& set) {
    NetworkConfig config = f2_config().network;
    set(config);
    EXPECT_THROW(PremotorNetwork{config}, std::invalid_argument);
  };
  refused([&](NetworkConfig& c) { c.cpg.w11 = kNan; });
  refused([&](NetworkConfig& c) { c.cpg.w12 = HUGE_VAL; });
  refused([&](NetworkConfig& c) { c.psn.input_weight = kNan; });
  refused([&](NetworkConfig& c) { c.psn.middle_bias = kNan; });
  refused([&](NetworkConfig& c) { c.vrn.hidden_bias = kNan; });
  refused([&](NetworkConfig& c) { c.hind_amplitude.t_i2_weight = -HUGE_VAL; });
  refused([&](NetworkConfig& c) { c.motor_bias.hind_c = kNan; });
}

}  // namespace
}  // namespace scarab::premotor
