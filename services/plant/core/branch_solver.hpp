#pragma once

#include <Eigen/Dense>
#include <array>

#include "services/plant/core/bodies.hpp"

namespace scarab::plant {

/// Solves A x = b for the system matrix of one step, leg by leg.
///
/// Legs are branches of a tree: two of them have no common entry in A unless they touch. So each
/// leg's three speeds are eliminated by themselves (block elimination, Schur complement),
/// which leaves 13 speeds: trunk, backbone and object. A leg that touches another is eliminated
/// into it, too. The same solution as a Cholesky decomposition of 31 x 31 (test), in a fifth of the
/// time.
class BranchSolver {
 public:
  /// Forgets which legs touch; call before couple().
  void begin() { coupled_ = {}; }

  /// Says that A has entries between two legs (slots).
  void couple(std::size_t leg, std::size_t other);

  /// `system`: symmetric and positive definite, its lower triangle is read.
  void factor(const SpeedMatrix& system);

  [[nodiscard]] SpeedVector solve(const SpeedVector& force) const;

 private:
  // Even sizes, so that columns stay aligned: the last row and column of the root are the
  // identity's.
  static constexpr int kRoot = 14;
  using Root = Eigen::Matrix<double, kRoot, 1>;
  using RootMatrix = Eigen::Matrix<double, kRoot, kRoot>;
  using RootLeg = Eigen::Matrix<double, kRoot, 3>;

  void gather(const SpeedMatrix& system);
  void eliminate(std::size_t leg);
  void factor_root();
  void solve_root(Root& x) const;

  /// What is left between legs and root, and the multipliers that eliminated it.
  std::array<Eigen::Matrix3d, robot::kLegCount> diagonal_, inverse_;
  std::array<RootLeg, robot::kLegCount> to_root_, root_multiplier_;
  std::array<std::array<Eigen::Matrix3d, robot::kLegCount>, robot::kLegCount> to_leg_,
      leg_multiplier_;  ///< [leg][later leg]
  std::array<std::array<bool, robot::kLegCount>, robot::kLegCount> coupled_{};  ///< as above
  RootMatrix root_;
  Root root_inverse_diagonal_;
};

}  // namespace scarab::plant
