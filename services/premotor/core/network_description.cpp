#include "services/premotor/core/network_description.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace scarab::premotor {

NeuronId NetworkDescription::add_input(std::string name) {
  if (inputs_.size() == kInputCount) {
    throw std::invalid_argument(name + ": a network has at most " + std::to_string(kInputCount) +
                                " input neurons");
  }
  const NeuronId id = add_neuron(std::move(name), Transfer::kLinear);
  inputs_.push_back(id);
  return id;
}

NeuronId NetworkDescription::add_neuron(std::string name, Transfer transfer, double bias) {
  if (!std::isfinite(bias)) {
    throw std::invalid_argument(name + ": bias is not finite");
  }
  const auto same = [&name](const Neuron& neuron) { return neuron.name == name; };
  if (std::any_of(neurons_.begin(), neurons_.end(), same)) {
    throw std::invalid_argument(name + ": there is already a neuron of that name");
  }
  neurons_.push_back({std::move(name), transfer, bias});
  return neurons_.size() - 1;
}

void NetworkDescription::connect(NeuronId from, NeuronId to, double weight) {
  require(from);
  require(to);
  if (!std::isfinite(weight)) {
    throw std::invalid_argument(neurons_[from].name + " -> " + neurons_[to].name +
                                ": weight is not finite");
  }
  synapses_.push_back({from, to, weight});
}

void NetworkDescription::connect(NeuronId from, NeuronId to, InputFunction weight) {
  require(from);
  require(to);
  modulatory_.push_back({from, to, weight});
}

void NetworkDescription::add_bias(NeuronId to, InputFunction bias) {
  require(to);
  input_driven_.push_back({to, bias});
}

NeuronId NetworkDescription::find(std::string_view name) const {
  const auto found = std::find_if(neurons_.begin(), neurons_.end(),
                                  [name](const Neuron& neuron) { return neuron.name == name; });
  if (found == neurons_.end()) {
    throw std::invalid_argument("no neuron is called " + std::string(name));
  }
  return static_cast<NeuronId>(found - neurons_.begin());
}

void NetworkDescription::require(NeuronId neuron) const {
  if (neuron >= neurons_.size()) {
    throw std::invalid_argument("neuron " + std::to_string(neuron) + " does not exist; there are " +
                                std::to_string(neurons_.size()));
  }
}

}  // namespace scarab::premotor
