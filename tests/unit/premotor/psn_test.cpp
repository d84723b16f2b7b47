#include "services/premotor/core/psn.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/premotor/f2_config.hpp"
#include "tests/unit/premotor/rhythm.hpp"

namespace scarab::premotor {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Signs of the outputs P13 of PSN1..PSN4 against what goes into P1 (the CPG's signal, or PSN1's
/// output), and of what reaches the joints against the CPG: + pass, - swap (facts of the phase
/// table in docs/equations.md).
struct Row {
  const char* action;
  std::array<int, 4> module;
  int front_middle_t;
  int front_middle_c;
  int hind_t;
};

void PrintTo(const Row& row, std::ostream* out) { *out << row.action; }

class PhaseTable : public testing::TestWithParam<Row> {};

/// The sign with which `output` carries `input`, which it follows by `steps` synapses; 0 if neither
/// sign fits within 20 deg.
int carried_sign(const Signal& output, const Signal& input, double omega, int steps) {
  const double rest = wrap(lag_rad(output, input, omega) - steps * omega);
  constexpr double kTolerance = kPi / 9;
  return std::abs(rest) < kTolerance ? 1 : std::abs(wrap(rest - kPi)) < kTolerance ? -1 : 0;
}

TEST_P(PhaseTable, HoldsOnTheRunningNetwork) {
  const Row& row = GetParam();
  MotorIntent intent;
  intent.inputs = action(row.action).inputs;
  const Recording recording = record(PremotorController(f2_config(), beetle()), intent);
  std::vector<std::array<double, 2>> orbit;
  for (const NetworkState& state : recording.states) {
    orbit.push_back(state.cpg);
  }
  const double omega = std::abs(turn_per_tick_rad(orbit));
  const auto of = [&](const auto& pick) { return signal(recording, pick); };
  const Signal cpg = of([](const NetworkState& s) { return s.cpg[0]; });
  const Signal psn1 = of([](const NetworkState& s) { return s.psn1[12]; });
  const Signal psn2 = of([](const NetworkState& s) { return s.psn2[12]; });
  const Signal psn3 = of([](const NetworkState& s) { return s.psn3[12]; });
  const Signal psn4 = of([](const NetworkState& s) { return s.psn4[12]; });

  // P1 -> P5 -> P9 -> P13: a signal is 4 steps late at the output.
  EXPECT_EQ(carried_sign(psn1, cpg, omega, 4), row.module[0]) << "PSN1";
  EXPECT_EQ(carried_sign(psn2, cpg, omega, 4), row.module[1]) << "PSN2";
  EXPECT_EQ(carried_sign(psn3, psn1, omega, 4), row.module[2]) << "PSN3";
  EXPECT_EQ(carried_sign(psn4, psn1, omega, 4), row.module[3]) << "PSN4";

  const Signal t = of([](const NetworkState& s) { return s.motor[0]; });       // TL0
  const Signal c = of([](const NetworkState& s) { return s.motor[6]; });       // CL0
  const Signal hind_t = of([](const NetworkState& s) { return s.motor[2]; });  // TL2
  EXPECT_EQ(carried_sign(t, cpg, omega, 8 + 2 + 1), row.front_middle_t) << "two steps of delay";
  EXPECT_EQ(carried_sign(c, cpg, omega, 8 + 1), row.front_middle_c);
  EXPECT_EQ(carried_sign(hind_t, cpg, omega, 4 + 3 + 1), row.hind_t) << "PSN2, VRN2";
}

TEST_P(PhaseTable, GatesAreComplementary) {
  const Inputs inputs = action(GetParam().action).inputs;
  for (const auto& [gates, modules] :
       {std::pair{driven_gates(), std::array{0, 3}}, std::pair{fixed_gates(), std::array{1, 2}}}) {
    const double p3 = gates.p3_sign * inputs[0] * inputs[0] + gates.p3_bias(inputs);
    const double p4 = -gates.p3_sign * inputs[0] * inputs[0] + gates.p4_bias(inputs);
    for (const int module : modules) {
      const bool pass = GetParam().module[static_cast<std::size_t>(module)] > 0;
      EXPECT_EQ(p3, pass ? 0 : 1) << "PSN" << module + 1;
      EXPECT_EQ(p4, pass ? 1 : 0) << "PSN" << module + 1;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Table1, PhaseTable,
                         testing::Values(Row{"forward", {1, 1, 1, 1}, 1, 1, 1},
                                         Row{"backward", {1, -1, -1, 1}, -1, 1, -1},
                                         Row{"soft_push", {-1, 1, 1, -1}, -1, 1, 1},
                                         Row{"boxing", {-1, 1, 1, -1}, -1, 1, 1},
                                         Row{"hard_push", {-1, 1, 1, -1}, -1, 1, 1}),
                         [](const auto& row) { return std::string(row.param.action); });

/// Settled outputs P13, P14 for constant signals into P1, P2 and the gates of the given I1, I2.
std::pair<double, double> settled(const PsnGates& gates, const Inputs& inputs, double signal_1,
                                  double signal_2) {
  NetworkDescription description;
  for (const char* name : {"I1", "I2", "I3", "I4"}) {
    description.add_input(name);
  }
  const PsnConfig config = f2_config().network.psn;
  const PsnNeurons psn = add_psn(description, "PSN", config, 0, gates);
  description.connect(2, psn.p1, config.input_weight);  // the signals come in through I3 and I4
  description.connect(3, psn.p2, config.input_weight);
  const Network network(std::move(description));
  Eigen::VectorXd output = Eigen::VectorXd::Zero(18);
  for (int i = 0; i < 8; ++i) {
    output = network.step(output, {inputs[0], inputs[1], signal_1, signal_2});
  }
  return {output[static_cast<Eigen::Index>(psn.p13)], output[static_cast<Eigen::Index>(psn.p14)]};
}

TEST(Psn, CarriesEachSignalToOneOutputAndSwapsThem) {
  const auto [open_13, open_14] = settled(fixed_gates(), {1, 0, 0, 0}, 0.8, -0.3);
  const auto [swapped_13, swapped_14] = settled(fixed_gates(), {0, 0, 0, 0}, 0.8, -0.3);
  EXPECT_GT(open_13, 0.3);
  EXPECT_LT(open_14, -0.05);
  EXPECT_DOUBLE_EQ(swapped_13, open_14);
  EXPECT_DOUBLE_EQ(swapped_14, open_13);
}

TEST(Psn, IsMonotonicAndKeepsTheAmplitudeWithinHalf) {
  double last = -1;
  for (double s = -0.94; s <= 0.94; s += 0.02) {
    const double p13 = settled(fixed_gates(), {1, 0, 0, 0}, s, -s).first;
    EXPECT_GT(p13, last) << "the periodic form is not changed";
    EXPECT_LT(std::abs(p13), 0.5) << "between -0.5 and +0.5 (paper, section 2.2)";
    last = p13;
  }
}

TEST(Psn, OfTheFirstLayerSpansTheAmplitudeOfThePrototype) {
  EXPECT_NEAR(settled(fixed_gates(), {1, 0, 0, 0}, 0.87, -0.87).first, 0.43, 0.01);
}

}  // namespace
}  // namespace scarab::premotor
