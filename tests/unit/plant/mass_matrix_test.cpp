#include "services/plant/core/mass_matrix.hpp"

#include <gtest/gtest.h>

#include "services/plant/core/simbody_model.hpp"
#include "tests/unit/plant/rig.hpp"

namespace scarab::plant {
namespace {

using testing::beetle;
using testing::default_config;
using testing::odd_state;

class MassMatrixTest : public ::testing::TestWithParam<int> {
 protected:
  MassMatrixTest() : morphology_(make_morphology(beetle(), default_config().object)) {}
  Morphology morphology_;
};

TEST_P(MassMatrixTest, AgreesWithSimbody) {
  SimbodyModel model(morphology_);
  model.finish();
  SimTK::State state = model.system.getDefaultState();
  const MotionState motion = odd_state(morphology_, GetParam());
  model.write(motion, state);
  model.system.realize(state, SimTK::Stage::Velocity);
  SimTK::Matrix expected;
  model.matter.calcM(state, expected);

  Kinematics kinematics;
  model.read_kinematics(state, kinematics);
  SpeedMatrix mass;
  SpeedVector gravity;
  MassMatrix(morphology_).compute(kinematics, 9.81, mass, gravity);
  const auto& index = model.speed_index();
  for (std::size_t i = 0; i < kSpeedCount; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      EXPECT_NEAR(mass(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)),
                  expected(index[i], index[j]), 1e-12)
          << "at " << i << ", " << j;
    }
  }
}

TEST_P(MassMatrixTest, GravityIsTheWeightOfEveryBody) {
  SimbodyModel model(morphology_);
  SimTK::Force::UniformGravity pull(model.forces, model.matter, SimTK::Vec3(0, 0, -9.81));
  model.finish();
  SimTK::State state = model.system.getDefaultState();
  const MotionState motion = odd_state(morphology_, GetParam());
  model.write(motion, state);
  model.system.realize(state, SimTK::Stage::Dynamics);
  SimTK::Vector expected;
  model.matter.multiplyBySystemJacobianTranspose(
      state, model.system.getRigidBodyForces(state, SimTK::Stage::Dynamics), expected);

  Kinematics kinematics;
  model.read_kinematics(state, kinematics);
  SpeedMatrix mass;
  SpeedVector gravity;
  MassMatrix(morphology_).compute(kinematics, 9.81, mass, gravity);
  for (std::size_t i = 0; i < kSpeedCount; ++i) {
    EXPECT_NEAR(gravity(static_cast<Eigen::Index>(i)), expected[model.speed_index()[i]], 1e-11);
  }
}

INSTANTIATE_TEST_SUITE_P(Poses, MassMatrixTest, ::testing::Range(0, 5));

}  // namespace
}  // namespace scarab::plant
