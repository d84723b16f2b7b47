#pragma once

#include "services/premotor/core/network_description.hpp"
#include "services/premotor/core/premotor_config.hpp"

namespace scarab::premotor {

struct CpgNeurons {
  NeuronId c1 = 0;
  NeuronId c2 = 0;
};

/// Adds the central pattern generator, neurons CPG.C1 and CPG.C2 (paper, section 2.1; Pasemann et
/// al. 2003):
///
///     C1 = tanh(w11 C1 + w12 C2),   C2 = tanh(-w12 C1 + w11 C2).
///
/// For w11^2 + w12^2 > 1 the origin is unstable and the orbit quasi-periodic on a closed curve; w12
/// / w11 sets its frequency.
CpgNeurons add_cpg(NetworkDescription& network, const CpgConfig& config);

}  // namespace scarab::premotor
