#pragma once

#include "services/premotor/core/network.hpp"
#include "services/premotor/core/network_state.hpp"
#include "services/premotor/core/premotor_config.hpp"

namespace scarab::premotor {

/// The paper's modular neural controller as one network (paper, section 2 and Fig. 1(a);
/// docs/equations.md):
///
///     I1..I4, CPG -> PSN1 -> PSN3 -> delay -> T motor neurons of the front and middle legs
///                    PSN1 -> PSN4          -> C motor neurons of the front and middle legs
///             CPG -> PSN2 -> VRN2          -> T motor neurons of the hind legs
///             CPG, PSN1   -> VRN1          -> C motor neurons of the hind legs
///
/// Motor neurons are linear [R] and take the tripod's sign as their weight. F- and backbone motor
/// neurons have no synapse: these joints are held at offsets that the motor map shifts. Deviations
/// from the paper: the gate biases (psn.hpp) and the delay line [R].
class PremotorNetwork {
 public:
  /// Throws std::invalid_argument for a weight that is not finite or a delay outside 0..8 ticks.
  explicit PremotorNetwork(const NetworkConfig& config);

  /// One synchronous update of all neurons with I1..I4 fed in.
  [[nodiscard]] NetworkState step(const NetworkState& state, const Inputs& fed) const;

  /// Names and synapses; neuron i is the i-th double of NetworkState.
  [[nodiscard]] const NetworkDescription& description() const { return network_.description(); }

 private:
  Network network_;
};

}  // namespace scarab::premotor
