#include "services/plant/core/forward_kinematics.hpp"

#include <gtest/gtest.h>

#include "tests/unit/plant/rig.hpp"

namespace scarab::plant {
namespace {

using testing::beetle;
using testing::default_config;

class ForwardKinematicsTest : public ::testing::TestWithParam<int> {
 protected:
  ForwardKinematicsTest() : morphology_(make_morphology(beetle(), default_config().object)) {}
  Morphology morphology_;
};

TEST_P(ForwardKinematicsTest, AgreesWithSimbody) {
  const MotionState motion = testing::odd_state(morphology_, GetParam());
  const Kinematics expected = testing::kinematics_of(morphology_, motion);
  Kinematics found;
  ForwardKinematics(morphology_).update(motion, found);
  for (std::size_t i = 0; i < kBodyCount; ++i) {
    const BodyMotion& a = found.body[i];
    const BodyMotion& b = expected.body[i];
    EXPECT_TRUE(a.R_world_body.isApprox(b.R_world_body, 1e-14)) << i;
    EXPECT_TRUE(a.position.isApprox(b.position, 1e-14)) << i;
    EXPECT_TRUE(a.angular_velocity.isApprox(b.angular_velocity, 1e-13)) << i;
    EXPECT_TRUE(a.velocity.isApprox(b.velocity, 1e-13)) << i;
  }
  for (std::size_t j = 0; j < robot::kJointCount; ++j) {
    EXPECT_TRUE(found.joint[j].direction.isApprox(expected.joint[j].direction, 1e-14)) << j;
    EXPECT_TRUE(found.joint[j].anchor.isApprox(expected.joint[j].anchor, 1e-14)) << j;
  }
}

INSTANTIATE_TEST_SUITE_P(Poses, ForwardKinematicsTest, ::testing::Range(0, 5));

TEST(ForwardKinematics, RefusesAnObliqueAxis) {
  Morphology morphology = make_morphology(beetle(), default_config().object);
  morphology.mounting[kFrontTrunkBody].axis_in_child = Eigen::Vector3d(0, 0.8, 0.6);
  EXPECT_THROW(ForwardKinematics{morphology}, std::invalid_argument);
}

}  // namespace
}  // namespace scarab::plant
