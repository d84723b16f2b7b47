#include "services/premotor/core/vrn.hpp"

#include <array>

namespace scarab::premotor {
namespace {

/// Square of the published bracket: 0 for soft pushing, 1 for the other rows of Table 1.
double squared_bracket(const Inputs& inputs) {
  const double i1 = inputs[0];
  const double i2 = inputs[1];
  const double difference = i1 * i1 - i2 * i2;
  const double bracket = difference * difference + i1 * i2 * (i2 + i1) / 2;
  return bracket * bracket;
}

/// Signs of V1 -> V3..V6, V2 -> V3..V6 and V3..V6 -> V7.
struct Branch {
  double v1;
  double v2;
  double v7;
};
constexpr std::array<Branch, 4> kBranches = {{{1, 1, 1}, {-1, -1, 1}, {1, -1, -1}, {-1, 1, -1}}};

}  // namespace

VrnNeurons add_vrn(NetworkDescription& network, const std::string& name, const VrnConfig& config,
                   double v1_bias) {
  std::array<NeuronId, 7> v{};
  for (std::size_t i = 0; i < v.size(); ++i) {
    const bool hidden = i >= 2 && i < 6;
    const double bias = i == 0 ? v1_bias : hidden ? config.hidden_bias : 0;
    v[i] = network.add_neuron(name + ".V" + std::to_string(i + 1), Transfer::kTanh, bias);
  }
  for (std::size_t k = 0; k < kBranches.size(); ++k) {
    network.connect(v[0], v[2 + k], kBranches[k].v1 * config.input_weight);
    network.connect(v[1], v[2 + k], kBranches[k].v2 * config.input_weight);
    network.connect(v[2 + k], v[6], kBranches[k].v7 * config.output_weight);
  }
  return {v[0], v[1], v[6]};
}

double vrn1_w9(const Inputs& inputs) { return 2 * squared_bracket(inputs); }
double vrn1_w10(const Inputs& inputs) { return 1 - vrn1_w9(inputs) / 2; }
double vrn1_b3(const Inputs& inputs) { return 0.02 * squared_bracket(inputs); }

}  // namespace scarab::premotor
