#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "services/premotor/core/network_description.hpp"

namespace scarab::premotor {

/// Discrete-time, non-spiking network with one synchronous update of all neurons (paper, section
/// 2):
///
///     a_i(t+1) = sum_j w_ij(t) o_j(t) + b_i(t),   o_i = tanh(a_i), or o_i = a_i for linear
///     neurons.
///
/// Modulatory weights and input-driven biases are functions of the input neurons' outputs at t. An
/// input neuron's activation is what is fed in. So one synapse takes one step, whichever it is.
/// Immutable.
class Network {
 public:
  /// Throws std::invalid_argument unless `description` has exactly kInputCount input neurons.
  explicit Network(NetworkDescription description);

  /// All outputs at t+1 from all outputs at t (both of length size()) and the numbers fed into
  /// I1..I4.
  [[nodiscard]] Eigen::VectorXd step(const Eigen::VectorXd& output, const Inputs& fed) const;

  [[nodiscard]] std::size_t size() const { return description_.size(); }
  [[nodiscard]] const NetworkDescription& description() const { return description_; }

 private:
  NetworkDescription description_;
  Eigen::SparseMatrix<double, Eigen::RowMajor> weights_;  ///< row: to, column: from
  Eigen::VectorXd biases_;
};

}  // namespace scarab::premotor
