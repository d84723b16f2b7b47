#include "services/plant/core/branch_solver.hpp"

#include <algorithm>

namespace scarab::plant {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using robot::kLegCount;

constexpr Index kBackbone = static_cast<Index>(kJointSpeed + robot::kBackboneSlot);
constexpr Index kObject = static_cast<Index>(kObjectSpeed);

/// Speed of a leg's joint k.
Index leg_speed(std::size_t leg, Index k) {
  return static_cast<Index>(kJointSpeed + 6 * static_cast<std::size_t>(k) + leg);
}

double lower(const SpeedMatrix& system, Index row, Index column) {
  return system(std::max(row, column), std::min(row, column));
}

Vector3d leg_part(const SpeedVector& v, std::size_t leg) {
  return {v(leg_speed(leg, 0)), v(leg_speed(leg, 1)), v(leg_speed(leg, 2))};
}

}  // namespace

void BranchSolver::begin() {
  coupled_ = {};
  root_rows_.fill(kRootWithoutObject);
}

void BranchSolver::couple(const SolidId& a, const SolidId& b) {
  if (!is_leg(b.solid)) return;
  if (is_leg(a.solid)) coupled_[std::min(a.leg, b.leg)][std::max(a.leg, b.leg)] = true;
  if (a.solid == Solid::kObject) root_rows_[b.leg] = kRoot;
}

void BranchSolver::gather(const SpeedMatrix& system) {
  root_.setZero();
  root_.block<6, 6>(0, 0) = system.block<6, 6>(0, 0);
  root_.block<1, 6>(6, 0) = system.block<1, 6>(kBackbone, 0);
  root_(6, 6) = system(kBackbone, kBackbone);
  root_.block<6, 6>(7, 0) = system.block<6, 6>(kObject, 0);
  root_.block<6, 1>(7, 6) = system.block<6, 1>(kObject, kBackbone);
  root_.block<6, 6>(7, 7) = system.block<6, 6>(kObject, kObject);
  root_(13, 13) = 1;
  for (std::size_t leg = 0; leg < kLegCount; ++leg) {
    for (Index k = 0; k < 3; ++k) {
      const Index at = leg_speed(leg, k);
      for (Index m = 0; m < 3; ++m) diagonal_[leg](m, k) = lower(system, leg_speed(leg, m), at);
      to_root_[leg].col(k) << system.block<1, 6>(at, 0).transpose(), system(kBackbone, at),
          system.block<6, 1>(kObject, at), 0;
    }
    for (std::size_t other = leg + 1; other < kLegCount; ++other) {
      if (!coupled_[leg][other]) continue;
      for (Index k = 0; k < 3; ++k) {
        for (Index m = 0; m < 3; ++m) {
          to_leg_[leg][other](m, k) = lower(system, leg_speed(other, m), leg_speed(leg, k));
        }
      }
    }
  }
}

/// root -= multiplier to_root^T: the lower triangle of its first rows, two at a time.
template <int Rows>
void BranchSolver::reduce_root(std::size_t leg) {
  const RootLeg& multiplier = root_multiplier_[leg];
  const RootLeg& entry = to_root_[leg];
#pragma GCC unroll 14
  for (int j = 0; j < Rows; ++j) {
#pragma GCC unroll 7
    for (int i = j & ~1; i < Rows; i += 2) {
      root_.block<2, 1>(i, j) -= multiplier.block<2, 1>(i, 0) * entry(j, 0) +
                                 multiplier.block<2, 1>(i, 1) * entry(j, 1) +
                                 multiplier.block<2, 1>(i, 2) * entry(j, 2);
    }
  }
}

void BranchSolver::eliminate(std::size_t leg) {
  inverse_[leg] = diagonal_[leg].inverse();
  root_multiplier_[leg].noalias() = to_root_[leg].lazyProduct(inverse_[leg]);
  if (root_rows_[leg] == kRoot) {
    reduce_root<kRoot>(leg);
  } else {
    reduce_root<kRootWithoutObject>(leg);
  }
  for (std::size_t a = leg + 1; a < kLegCount; ++a) {
    if (!coupled_[leg][a]) continue;
    Matrix3d& multiplier = leg_multiplier_[leg][a];
    multiplier = to_leg_[leg][a] * inverse_[leg];
    diagonal_[a] -= multiplier * to_leg_[leg][a].transpose();
    root_rows_[a] = std::max(root_rows_[a], root_rows_[leg]);
    to_root_[a].noalias() -= to_root_[leg].lazyProduct(multiplier.transpose());
    for (std::size_t b = leg + 1; b < a; ++b) {
      if (!coupled_[leg][b]) continue;
      if (!coupled_[b][a]) to_leg_[b][a].setZero();
      coupled_[b][a] = true;
      to_leg_[b][a] -= multiplier * to_leg_[leg][b].transpose();
    }
  }
}

/// L D L^T in the lower triangle, two rows at a time.
void BranchSolver::factor_root() {
#pragma GCC unroll 14
  for (int k = 0; k < kRoot; ++k) {
    const double inverse = 1 / root_(k, k);
    root_inverse_diagonal_(k) = inverse;
#pragma GCC unroll 14
    for (int j = k + 1; j < kRoot; ++j) {
      const double multiplier = root_(j, k) * inverse;
#pragma GCC unroll 7
      for (int i = j & ~1; i < kRoot; i += 2) {
        root_.block<2, 1>(i, j) -= multiplier * root_.block<2, 1>(i, k);
      }
    }
    for (int i = k + 1; i < kRoot; ++i) root_(i, k) *= inverse;
  }
}

void BranchSolver::factor(const SpeedMatrix& system) {
  gather(system);
  for (std::size_t leg = 0; leg < kLegCount; ++leg) eliminate(leg);
  factor_root();
}

void BranchSolver::solve_root(Root& x) const {
  for (int k = 0; k < kRoot; ++k) {
    for (int i = k + 1; i < kRoot; ++i) x(i) -= root_(i, k) * x(k);
  }
  x.array() *= root_inverse_diagonal_.array();
  for (int k = kRoot - 1; k-- > 0;) {
    for (int i = k + 1; i < kRoot; ++i) x(k) -= root_(i, k) * x(i);
  }
}

SpeedVector BranchSolver::solve(const SpeedVector& force) const {
  std::array<Vector3d, kLegCount> leg_x;
  for (std::size_t leg = 0; leg < kLegCount; ++leg) leg_x[leg] = leg_part(force, leg);
  Root root_x;
  root_x << force.segment<6>(0), force(kBackbone), force.segment<6>(kObject), 0;

  for (std::size_t leg = 0; leg < kLegCount; ++leg) {
    root_x -= root_multiplier_[leg].lazyProduct(leg_x[leg]);
    for (std::size_t other = leg + 1; other < kLegCount; ++other) {
      if (coupled_[leg][other]) leg_x[other] -= leg_multiplier_[leg][other] * leg_x[leg];
    }
  }
  solve_root(root_x);
  SpeedVector x;
  x.segment<6>(0) = root_x.head<6>();
  x(kBackbone) = root_x(6);
  x.segment<6>(kObject) = root_x.segment<6>(7);
  for (std::size_t leg = kLegCount; leg-- > 0;) {
    Vector3d solution = inverse_[leg] * leg_x[leg];
    solution -= root_multiplier_[leg].transpose().lazyProduct(root_x);
    for (std::size_t other = leg + 1; other < kLegCount; ++other) {
      if (coupled_[leg][other]) {
        solution -= leg_multiplier_[leg][other].transpose() * leg_x[other];
      }
    }
    leg_x[leg] = solution;
    for (Index k = 0; k < 3; ++k) x(leg_speed(leg, k)) = solution(k);
  }
  return x;
}

}  // namespace scarab::plant
