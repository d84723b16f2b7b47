#include "services/plant/core/inertial_force.hpp"

#include <gtest/gtest.h>

#include "services/plant/core/robot_tree.hpp"
#include "tests/unit/plant/rig.hpp"

namespace scarab::plant {
namespace {

using testing::beetle;
using testing::default_config;

class InertialForceTest : public ::testing::TestWithParam<int> {
 protected:
  InertialForceTest() : morphology_(make_morphology(beetle(), default_config().object)) {}
  Morphology morphology_;
};

TEST_P(InertialForceTest, IsSimbodysInverseDynamicsWithoutAcceleration) {
  RobotTree tree(morphology_);
  Kinematics kinematics;
  tree.update(testing::odd_state(morphology_, GetParam()), kinematics);
  SpeedVector expected;
  tree.inverse_dynamics(SpeedVector::Zero(), expected);
  SpeedVector found;
  InertialForce(morphology_).compute(kinematics, found);
  EXPECT_GT(expected.norm(), 0.1) << "the state is at speed";
  for (Eigen::Index i = 0; i < found.size(); ++i) EXPECT_NEAR(found(i), expected(i), 1e-13) << i;
}

INSTANTIATE_TEST_SUITE_P(Poses, InertialForceTest, ::testing::Range(0, 5));

TEST(InertialForce, VanishesAtRest) {
  const Morphology morphology = make_morphology(beetle(), default_config().object);
  MotionState motion = testing::odd_state(morphology, 1);
  motion.speed.setZero();
  SpeedVector force;
  InertialForce(morphology).compute(testing::kinematics_of(morphology, motion), force);
  EXPECT_EQ(force, SpeedVector::Zero());
}

}  // namespace
}  // namespace scarab::plant
