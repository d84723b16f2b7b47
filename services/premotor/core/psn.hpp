#pragma once

#include <string>

#include "services/premotor/core/network_description.hpp"
#include "services/premotor/core/premotor_config.hpp"

namespace scarab::premotor {

/// The neurons of a PSN that others connect to. P1, P2: signals; P3, P4: gates, 0 open and 1
/// closed; P13, P14: outputs.
struct PsnNeurons {
  NeuronId p1 = 0;
  NeuronId p2 = 0;
  NeuronId p3 = 0;
  NeuronId p4 = 0;
  NeuronId p13 = 0;
  NeuronId p14 = 0;
};

/// How a PSN's gates follow I1: w(I1 -> P3) = p3_sign I1 and w(I1 -> P4) = -p3_sign I1, and the
/// biases b1, b2.
struct PsnGates {
  double p3_sign = 1;
  InputFunction p3_bias = nullptr;
  InputFunction p4_bias = nullptr;
};

/// PSN1 and PSN4: w1 = w7 = I1, w2 = w8 = -I1, b1 = -(I1^2 I2 (I2 + 1)) / 2 and b2 = 1 - b1. The
/// paper prints b2 = -b1, with which the gates are not complementary; the added 1 is a
/// reconstruction [R], docs/equations.md.
PsnGates driven_gates();

/// PSN2 and PSN3: w4 = w6 = I1, w3 = w5 = -I1, b1 = 1 and b2 = 0. The paper prints b1 = -1; the
/// sign is a reconstruction [R].
PsnGates fixed_gates();

/// Adds a phase switching network, neurons <name>.P1 to <name>.P14 in four layers (paper,
/// section 2.2 and Fig. 3). With gates (P3, P4) = (0, 1) P13 carries the signal of P1 and P14 that
/// of P2; with (1, 0) they are swapped. The caller connects the signals to P1 and P2 with
/// config.input_weight.
PsnNeurons add_psn(NetworkDescription& network, const std::string& name, const PsnConfig& config,
                   NeuronId i1, const PsnGates& gates);

}  // namespace scarab::premotor
