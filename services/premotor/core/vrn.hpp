#pragma once

#include <string>

#include "services/premotor/core/network_description.hpp"
#include "services/premotor/core/premotor_config.hpp"

namespace scarab::premotor {

/// The neurons of a VRN that others connect to: V1 amplitude, V2 signal, V7 their product.
struct VrnNeurons {
  NeuronId v1 = 0;
  NeuronId v2 = 0;
  NeuronId v7 = 0;
};

/// Adds a velocity regulating network, neurons <name>.V1 to <name>.V7 in three layers (paper,
/// section 2.3 and Fig. 4). V7 is about V1 V2: its argument is within 0.14 of the product, V7
/// itself within 0.30 (its tanh compresses large products). The caller connects V1 and V2.
VrnNeurons add_vrn(NetworkDescription& network, const std::string& name, const VrnConfig& config,
                   double v1_bias);

/// Weights and bias of VRN1.V2 as functions of I1, I2 (paper, section 2.3): with the bracket
/// q = (I1^2 - I2^2)^2 + I1 I2 (I2 + I1) / 2, w9 = 2 q^2 (from the CPG), w10 = 1 - w9 / 2 (from
/// PSN1.P13), b3 = 0.02 q^2.
double vrn1_w9(const Inputs& inputs);
double vrn1_w10(const Inputs& inputs);
double vrn1_b3(const Inputs& inputs);

}  // namespace scarab::premotor
