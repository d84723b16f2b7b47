#include "services/plant/core/branch_solver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "services/plant/core/contact_jacobian.hpp"
#include "services/plant/core/mass_matrix.hpp"
#include "tests/unit/plant/rig.hpp"

namespace scarab::plant {
namespace {

using Pair = std::pair<std::size_t, std::size_t>;

SolidId tibia(std::size_t leg) {
  return {Solid::kTibia, static_cast<std::uint16_t>(leg),
          leg_body(robot::kLegs[leg], LegSegment::kTibia)};
}

constexpr SolidId kGround{Solid::kGround, 0, kWorldBody};
constexpr SolidId kObject{Solid::kObject, 0, kObjectBody};

class BranchSolverTest : public ::testing::TestWithParam<std::vector<Pair>> {
 protected:
  BranchSolverTest()
      : morphology_(make_morphology(testing::beetle(), testing::default_config().object)),
        kinematics_(testing::kinematics_of(morphology_, testing::odd_state(morphology_, 2))) {
    SpeedVector gravity;
    MassMatrix(morphology_).compute(kinematics_, 9.81, system_, gravity);
    system_.diagonal().array() += 0.01;
  }

  void add_contact(const SolidId& a, const SolidId& b) {
    const Eigen::Vector3d normal = Eigen::Vector3d(1, -2, 3).normalized();
    const Eigen::Vector3d point = kinematics_.body[b.body].position + normal;
    const ContactJacobian jacobian(kinematics_, morphology_.leg_on_front,
                                   {a, b, {point, normal, 0.001}, 0});
    jacobian.add_damping(normal, 0.5, 20, system_);
    solver_.couple(a, b);
  }

  Morphology morphology_;
  Kinematics kinematics_;
  SpeedMatrix system_;
  BranchSolver solver_;
};

/// Feet on the ground and at the object, and legs that touch each other.
TEST_P(BranchSolverTest, AgreesWithADenseCholesky) {
  solver_.begin();
  add_contact(kGround, kObject);
  add_contact(kGround, tibia(1));
  add_contact(kObject, tibia(0));
  add_contact(kObject, tibia(5));
  add_contact(kObject, {Solid::kTrunk, 0, kFrontTrunkBody});
  for (const auto& [leg, other] : GetParam()) {
    add_contact(tibia(std::min(leg, other)), tibia(std::max(leg, other)));
  }
  solver_.factor(system_);
  const Eigen::LLT<SpeedMatrix> dense(system_);
  for (int i = 0; i < 3; ++i) {
    const SpeedVector force = SpeedVector::LinSpaced(-1.0 + i, 3.0 - 2 * i);
    const SpeedVector expected = dense.solve(force);
    const SpeedVector found = solver_.solve(force);
    EXPECT_LT((found - expected).norm(), 1e-9 * expected.norm());
    const SpeedMatrix full = system_.selfadjointView<Eigen::Lower>();
    EXPECT_LT((full * found - force).norm(), 1e-14 * full.norm() * found.norm());
  }
}

INSTANTIATE_TEST_SUITE_P(
    TouchingLegs, BranchSolverTest,
    ::testing::Values(std::vector<Pair>{}, std::vector<Pair>{{1, 2}}, std::vector<Pair>{{2, 1}},
                      std::vector<Pair>{{0, 1}, {1, 2}}, std::vector<Pair>{{0, 1}, {0, 2}, {0, 3}},
                      std::vector<Pair>{{0, 5}, {5, 2}, {3, 2}, {3, 4}, {1, 4}}));

TEST(BranchSolver, ForgetsWhichLegsTouched) {
  SpeedMatrix system = SpeedMatrix::Identity();
  BranchSolver solver;
  solver.begin();
  solver.couple(tibia(0), tibia(1));
  solver.couple(kObject, tibia(0));
  solver.factor(2 * system);
  solver.begin();
  solver.factor(system);
  EXPECT_EQ(solver.solve(SpeedVector::Ones()), SpeedVector::Ones());
}

}  // namespace
}  // namespace scarab::plant
