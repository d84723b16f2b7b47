#include "services/plant/core/simbody_check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "services/plant/core/forward_kinematics.hpp"
#include "services/plant/core/inertial_force.hpp"
#include "services/plant/core/mass_matrix.hpp"
#include "tests/unit/plant/rig.hpp"

namespace scarab::plant {
namespace {

class SimbodyCheckTest : public ::testing::Test {
 protected:
  SimbodyCheckTest()
      : morphology_(make_morphology(testing::beetle(), testing::default_config().object)),
        motion_(testing::odd_state(morphology_, 3)),
        check_(morphology_) {
    account(morphology_);
  }

  /// The account that a robot of `morphology` would give of the motion.
  void account(const Morphology& morphology) {
    SpeedVector gravity;
    ForwardKinematics(morphology).update(motion_, kinematics_);
    MassMatrix(morphology).compute(kinematics_, 9.81, mass_, gravity);
    InertialForce(morphology).compute(kinematics_, inertial_);
  }

  void compare() {
    check_.compare(motion_, kinematics_, mass_, inertial_, SpeedVector::LinSpaced(-3, 5));
  }

  Morphology morphology_;
  MotionState motion_;
  SimbodyCheck check_;
  Kinematics kinematics_;
  SpeedMatrix mass_;
  SpeedVector inertial_;
};

TEST_F(SimbodyCheckTest, AgreesOnTheSameRobot) { EXPECT_NO_THROW(compare()); }

TEST_F(SimbodyCheckTest, FindsAnotherLength) {
  Morphology other = morphology_;
  other.mounting[leg_body(robot::Leg::kR1, LegSegment::kTibia)].position_in_parent.y() *= 1.0001;
  account(other);
  EXPECT_THROW(compare(), std::logic_error);
}

TEST_F(SimbodyCheckTest, FindsAnotherMass) {
  Morphology other = morphology_;
  other.mass[leg_body(robot::Leg::kL2, LegSegment::kFemur)].mass_kg *= 1.0001;
  account(other);
  EXPECT_THROW(compare(), std::logic_error);
}

TEST_F(SimbodyCheckTest, FindsAForgottenCoriolisForce) {
  inertial_.setZero();
  EXPECT_THROW(compare(), std::logic_error);
}

TEST_F(SimbodyCheckTest, LeavesAMotionThatIsNotFiniteToOthers) {
  motion_.speed(0) = std::numeric_limits<double>::quiet_NaN();
  account(morphology_);
  EXPECT_NO_THROW(compare());
}

}  // namespace
}  // namespace scarab::plant
