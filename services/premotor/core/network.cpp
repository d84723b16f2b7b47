#include "services/premotor/core/network.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace scarab::premotor {
namespace {

Eigen::Index index(NeuronId neuron) { return static_cast<Eigen::Index>(neuron); }

}  // namespace

Network::Network(NetworkDescription description)
    : description_(std::move(description)),
      weights_(index(description_.size()), index(description_.size())),
      biases_(index(description_.size())) {
  if (description_.inputs().size() != kInputCount) {
    throw std::invalid_argument("a network needs " + std::to_string(kInputCount) +
                                " input neurons");
  }
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(description_.synapses().size());
  for (const Synapse& synapse : description_.synapses()) {
    entries.emplace_back(static_cast<int>(synapse.to), static_cast<int>(synapse.from),
                         synapse.weight);
  }
  weights_.setFromTriplets(entries.begin(), entries.end());
  for (NeuronId i = 0; i < description_.size(); ++i) {
    biases_[index(i)] = description_.neurons()[i].bias;
  }
}

Eigen::VectorXd Network::step(const Eigen::VectorXd& output, const Inputs& fed) const {
  Inputs inputs{};
  for (std::size_t i = 0; i < kInputCount; ++i) {
    inputs[i] = output[index(description_.inputs()[i])];
  }
  Eigen::VectorXd next = weights_ * output + biases_;
  for (const ModulatorySynapse& synapse : description_.modulatory()) {
    next[index(synapse.to)] += synapse.weight(inputs) * output[index(synapse.from)];
  }
  for (const InputDrivenBias& driven : description_.input_driven()) {
    next[index(driven.to)] += driven.bias(inputs);
  }
  for (std::size_t i = 0; i < kInputCount; ++i) {
    next[index(description_.inputs()[i])] += fed[i];
  }
  // std::tanh and not Eigen's: the C library's is the same on every instruction set of a machine.
  for (NeuronId i = 0; i < description_.size(); ++i) {
    if (description_.neurons()[i].transfer == Transfer::kTanh) {
      next[index(i)] = std::tanh(next[index(i)]);
    }
  }
  return next;
}

}  // namespace scarab::premotor
