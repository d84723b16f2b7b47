#include "services/premotor/core/premotor_network.hpp"

#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>

#include "services/premotor/core/cpg.hpp"
#include "services/premotor/core/psn.hpp"
#include "services/premotor/core/vrn.hpp"

namespace scarab::premotor {
namespace {

using robot::Leg;
using robot::LegJoint;

constexpr std::size_t kDelayPlaces = std::tuple_size_v<decltype(NetworkState::delay_line)>;

/// A neuron and the share of its output: two of them interpolate between two places of the delay
/// line.
struct Tap {
  NeuronId neuron = 0;
  double share = 0;
};
using Taps = std::array<Tap, 2>;

/// Adds D1..D8, D1 listening to `source`; returns the taps at which `source` is `ticks` steps late.
/// Places that the delay does not need stay unconnected, so their output is 0.
Taps add_delay_line(NetworkDescription& network, NeuronId source, double ticks) {
  if (!(ticks >= 0 && ticks <= static_cast<double>(kDelayPlaces))) {
    throw std::invalid_argument("delay of the T-joints: " + std::to_string(ticks) +
                                " ticks is not in 0.." + std::to_string(kDelayPlaces));
  }
  const auto needed = static_cast<std::size_t>(std::ceil(ticks));
  std::array<NeuronId, kDelayPlaces + 1> place{source};
  for (std::size_t i = 1; i <= kDelayPlaces; ++i) {
    place[i] = network.add_neuron("DELAY.D" + std::to_string(i), Transfer::kLinear);
    if (i <= needed) {
      network.connect(place[i - 1], place[i], 1);
    }
  }
  const auto whole = static_cast<std::size_t>(ticks);
  const double fraction = ticks - static_cast<double>(whole);
  return {{{place[whole], 1 - fraction}, {place[needed], fraction}}};
}

void connect_signals(NetworkDescription& network, const PsnNeurons& psn, const Tap& p1,
                     const Tap& p2) {
  network.connect(p1.neuron, psn.p1, p1.share);
  network.connect(p2.neuron, psn.p2, p2.share);
}

/// What drives the T- and C-joints of one group of legs.
struct Drive {
  Taps t;
  NeuronId c = 0;
  double t_bias = 0;
  double c_bias = 0;
};

/// Synapses and biases of the T- and C-motor neurons take the tripod's sign; F and backbone have
/// neither.
void add_motor_neurons(NetworkDescription& network, const Drive& front_middle, const Drive& hind) {
  const auto drive_of = [&](Leg leg) { return robot::row(leg) == 2 ? hind : front_middle; };
  std::array<double, robot::kJointCount> bias{};
  for (const Leg leg : robot::kLegs) {
    const double sign = robot::tripod_sign(leg);
    bias[joint_slot(leg, LegJoint::kThoracoCoxal)] = sign * drive_of(leg).t_bias;
    bias[joint_slot(leg, LegJoint::kCoxaTrochanteral)] = sign * drive_of(leg).c_bias;
  }
  std::array<NeuronId, robot::kJointCount> motor{};
  for (std::size_t slot = 0; slot < robot::kJointCount; ++slot) {
    motor[slot] = network.add_neuron("MN." + std::string(robot::kJointNames[slot]),
                                     Transfer::kLinear, bias[slot]);
  }
  for (const Leg leg : robot::kLegs) {
    const double sign = robot::tripod_sign(leg);
    for (const Tap& tap : drive_of(leg).t) {
      if (tap.share != 0) {
        network.connect(tap.neuron, motor[joint_slot(leg, LegJoint::kThoracoCoxal)],
                        sign * tap.share);
      }
    }
    network.connect(drive_of(leg).c, motor[joint_slot(leg, LegJoint::kCoxaTrochanteral)], sign);
  }
}

/// Neurons are added in the order of NetworkState's members.
NetworkDescription describe(const NetworkConfig& config) {
  NetworkDescription net;
  const NeuronId i1 = net.add_input("I1");
  const NeuronId i2 = net.add_input("I2");
  const NeuronId i3 = net.add_input("I3");
  net.add_input("I4");
  const CpgNeurons cpg = add_cpg(net, config.cpg);

  const PsnNeurons psn1 = add_psn(net, "PSN1", config.psn, i1, driven_gates());
  const PsnNeurons psn2 = add_psn(net, "PSN2", config.psn, i1, fixed_gates());
  const PsnNeurons psn3 = add_psn(net, "PSN3", config.psn, i1, fixed_gates());
  const PsnNeurons psn4 = add_psn(net, "PSN4", config.psn, i1, driven_gates());
  const double w = config.psn.input_weight;
  connect_signals(net, psn1, {cpg.c1, w}, {cpg.c1, -w});
  connect_signals(net, psn2, {cpg.c1, w}, {cpg.c1, -w});
  connect_signals(net, psn3, {psn1.p13, w}, {psn1.p14, w});
  connect_signals(net, psn4, {psn1.p13, w}, {psn1.p14, w});

  const HindAmplitudeConfig& amplitude = config.hind_amplitude;
  const VrnNeurons vrn1 = add_vrn(net, "VRN1", config.vrn, amplitude.c_bias);
  net.connect(i3, vrn1.v1, amplitude.c_i3_weight);
  net.connect(cpg.c1, vrn1.v2, vrn1_w9);
  net.connect(psn1.p13, vrn1.v2, vrn1_w10);
  net.add_bias(vrn1.v2, vrn1_b3);
  const VrnNeurons vrn2 = add_vrn(net, "VRN2", config.vrn, amplitude.t_bias);
  net.connect(i2, vrn2.v1, amplitude.t_i2_weight);
  net.connect(psn2.p13, vrn2.v2, 1);

  const Taps delayed = add_delay_line(net, psn3.p13, config.t_delay_ticks);
  const MotorBiasConfig& bias = config.motor_bias;
  add_motor_neurons(net, {delayed, psn4.p13, bias.front_middle_t, bias.front_middle_c},
                    {{{{vrn2.v7, 1}, {}}}, vrn1.v7, bias.hind_t, bias.hind_c});
  return net;
}

}  // namespace

PremotorNetwork::PremotorNetwork(const NetworkConfig& config) : network_(describe(config)) {}

NetworkState PremotorNetwork::step(const NetworkState& state, const Inputs& fed) const {
  Eigen::VectorXd output(static_cast<Eigen::Index>(kNeuronCount));
  std::memcpy(output.data(), &state, sizeof(state));
  const Eigen::VectorXd next = network_.step(output, fed);
  NetworkState result;
  std::memcpy(static_cast<void*>(&result), next.data(), sizeof(result));
  return result;
}

}  // namespace scarab::premotor
