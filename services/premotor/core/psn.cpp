#include "services/premotor/core/psn.hpp"

#include <array>

namespace scarab::premotor {
namespace {

double excitatory(const Inputs& inputs) { return inputs[0]; }
double inhibitory(const Inputs& inputs) { return -inputs[0]; }

/// b1 of PSN1 and PSN4 as published: -1 for I1^2 = I2 = 1, and 0 for the other rows of Table 1.
double published_b1(const Inputs& inputs) {
  const double i1 = inputs[0];
  const double i2 = inputs[1];
  return -(i1 * i1 * i2 * (i2 + 1)) / 2;
}
double complementary_b2(const Inputs& inputs) { return 1 - published_b1(inputs); }
double one(const Inputs& /*inputs*/) { return 1; }
double zero(const Inputs& /*inputs*/) { return 0; }

/// Which of P1, P2 and which of P3, P4 each of P5..P8 listens to.
struct Branch {
  std::size_t signal;
  std::size_t gate;
};
constexpr std::array<Branch, 4> kBranches = {{{0, 2}, {1, 3}, {1, 2}, {0, 3}}};

}  // namespace

PsnGates driven_gates() { return {1, published_b1, complementary_b2}; }

PsnGates fixed_gates() { return {-1, one, zero}; }

PsnNeurons add_psn(NetworkDescription& network, const std::string& name, const PsnConfig& config,
                   NeuronId i1, const PsnGates& gates) {
  std::array<NeuronId, 14> p{};
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double bias = i < 8 ? 0 : i < 12 ? config.middle_bias : config.output_bias;
    p[i] = network.add_neuron(name + ".P" + std::to_string(i + 1), Transfer::kTanh, bias);
  }
  network.connect(i1, p[2], gates.p3_sign > 0 ? excitatory : inhibitory);
  network.connect(i1, p[3], gates.p3_sign > 0 ? inhibitory : excitatory);
  network.add_bias(p[2], gates.p3_bias);
  network.add_bias(p[3], gates.p4_bias);
  for (std::size_t k = 0; k < kBranches.size(); ++k) {
    network.connect(p[kBranches[k].signal], p[4 + k], config.signal_weight);
    network.connect(p[kBranches[k].gate], p[4 + k], config.gate_weight);
    network.connect(p[4 + k], p[8 + k], config.middle_weight);
    network.connect(p[8 + k], p[k < 2 ? 12 : 13], config.output_weight);
  }
  return {p[0], p[1], p[2], p[3], p[12], p[13]};
}

}  // namespace scarab::premotor
