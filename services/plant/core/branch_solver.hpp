#pragma once

#include <Eigen/Dense>
#include <array>

#include "services/plant/core/bodies.hpp"
#include "services/plant/core/contact.hpp"

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
  /// Forgets what touches; call before couple().
  void begin();

  /// Says that A has entries between the speeds of two solids.
  void couple(const SolidId& a, const SolidId& b);

  /// `system`: symmetric and positive definite, its lower triangle is read.
  void factor(const SpeedMatrix& system);

  [[nodiscard]] SpeedVector solve(const SpeedVector& force) const;

 private:
  // Even sizes, so that columns stay aligned: the last row and column of the root are the
  // identity's.
  static constexpr int kRoot = 14;
  static constexpr int kRootWithoutObject = 8;  ///< covers trunk and backbone
  using Root = Eigen::Matrix<double, kRoot, 1>;
  using RootMatrix = Eigen::Matrix<double, kRoot, kRoot>;
  using RootLeg = Eigen::Matrix<double, kRoot, 3>;

  void gather(const SpeedMatrix& system);
  void eliminate(std::size_t leg);
  template <int Rows>
  void reduce_root(std::size_t leg);
  void factor_root();
  void solve_root(Root& x) const;

  /// What is left between legs and root, and the multipliers that eliminated it.
  std::array<Eigen::Matrix3d, robot::kLegCount> diagonal_, inverse_;
  std::array<RootLeg, robot::kLegCount> to_root_, root_multiplier_;
  std::array<std::array<Eigen::Matrix3d, robot::kLegCount>, robot::kLegCount> to_leg_,
      leg_multiplier_;  ///< [leg][later leg]
  std::array<std::array<bool, robot::kLegCount>, robot::kLegCount> coupled_{};  ///< as above
  std::array<int, robot::kLegCount> root_rows_{};  ///< of to_root_ that are not 0
  RootMatrix root_;
  Root root_inverse_diagonal_;
};

}  // namespace scarab::plant
