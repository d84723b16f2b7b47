#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace scarab::premotor {

/// Place of a neuron in the order in which it was added.
using NeuronId = std::size_t;

/// tanh, or o = a (linear buffer).
enum class Transfer { kTanh, kLinear };

/// I1..I4, in this order.
inline constexpr std::size_t kInputCount = 4;
using Inputs = std::array<double, kInputCount>;

/// A weight or bias that is a function of I1..I4 (paper, sections 2.2 and 2.3).
using InputFunction = double (*)(const Inputs&);

struct Neuron {
  std::string name;
  Transfer transfer = Transfer::kTanh;
  double bias = 0;
};

struct Synapse {
  NeuronId from = 0;
  NeuronId to = 0;
  double weight = 0;
};

/// A synapse whose weight is evaluated anew at each step.
struct ModulatorySynapse {
  NeuronId from = 0;
  NeuronId to = 0;
  InputFunction weight = nullptr;
};

/// A bias that is evaluated anew at each step, added to the neuron's fixed one.
struct InputDrivenBias {
  NeuronId to = 0;
  InputFunction bias = nullptr;
};

/// What a network is made of: named neurons and the synapses between them. The modules' builders
/// (cpg.hpp, psn.hpp, vrn.hpp) add to it; Network runs it. Every function throws
/// std::invalid_argument, naming the neurons, for a weight or bias that is not finite, a name used
/// twice or a neuron that is not there.
class NetworkDescription {
 public:
  /// Adds an input neuron, a linear buffer of one number from outside. The first is I1; at most
  /// kInputCount.
  NeuronId add_input(std::string name);
  NeuronId add_neuron(std::string name, Transfer transfer, double bias = 0);
  void connect(NeuronId from, NeuronId to, double weight);
  void connect(NeuronId from, NeuronId to, InputFunction weight);
  void add_bias(NeuronId to, InputFunction bias);

  [[nodiscard]] std::size_t size() const { return neurons_.size(); }
  /// The neuron of that name, such as "PSN1.P13".
  [[nodiscard]] NeuronId find(std::string_view name) const;

  [[nodiscard]] const std::vector<Neuron>& neurons() const { return neurons_; }
  [[nodiscard]] const std::vector<NeuronId>& inputs() const { return inputs_; }
  [[nodiscard]] const std::vector<Synapse>& synapses() const { return synapses_; }
  [[nodiscard]] const std::vector<ModulatorySynapse>& modulatory() const { return modulatory_; }
  [[nodiscard]] const std::vector<InputDrivenBias>& input_driven() const { return input_driven_; }

 private:
  void require(NeuronId neuron) const;

  std::vector<Neuron> neurons_;
  std::vector<NeuronId> inputs_;
  std::vector<Synapse> synapses_;
  std::vector<ModulatorySynapse> modulatory_;
  std::vector<InputDrivenBias> input_driven_;
};

}  // namespace scarab::premotor
