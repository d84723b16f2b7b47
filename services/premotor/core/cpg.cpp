#include "services/premotor/core/cpg.hpp"

namespace scarab::premotor {

CpgNeurons add_cpg(NetworkDescription& network, const CpgConfig& config) {
  const NeuronId c1 = network.add_neuron("CPG.C1", Transfer::kTanh);
  const NeuronId c2 = network.add_neuron("CPG.C2", Transfer::kTanh);
  network.connect(c1, c1, config.w11);
  network.connect(c2, c1, config.w12);
  network.connect(c1, c2, -config.w12);
  network.connect(c2, c2, config.w11);
  return {c1, c2};
}

}  // namespace scarab::premotor
