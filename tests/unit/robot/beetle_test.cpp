#include <gtest/gtest.h>

#include <cmath>

#include "common/config/robot_file.hpp"
#include "common/robot/joint_limits.hpp"
#include "common/robot/mass.hpp"

namespace scarab::robot {
namespace {

RobotModel beetle() { return config::load_robot(SCARAB_SOURCE_DIR "/config/robot/beetle.yaml"); }

double degrees(double angle_rad) { return angle_rad * 180.0 / M_PI; }

TEST(Beetle, HasThePapersSizeAndMass) {
  const RobotModel model = beetle();
  EXPECT_EQ(model.name, "beetle");
  EXPECT_NEAR(total_mass_kg(model), 5.0, 0.1);    // paper: about 5 kg
  EXPECT_DOUBLE_EQ(model.trunk.height_m, 0.065);  // paper: body height 6.5 cm
  EXPECT_DOUBLE_EQ(model.trunk.length_m / 2 - model.trunk.hinge_x_m, 0.12);  // front segment
}

TEST(Beetle, HasNineteenJointsWithTheLaboratorysRanges) {
  const RobotModel model = beetle();
  for (const Joint& joint : model.joints) {
    EXPECT_TRUE(joint.present);
    EXPECT_GT(joint.torque_max_nm, 0);
    EXPECT_LE(joint.velocity_max_rad_s, 10.5);
  }
  const Joint& front_c = model.joints[joint_slot(Leg::kL0, LegJoint::kCoxaTrochanteral)];
  EXPECT_NEAR(degrees(front_c.min_rad), -60, 1e-9);  // down is negative
  EXPECT_NEAR(degrees(front_c.max_rad), 10, 1e-9);
  const Joint& hind_t = model.joints[joint_slot(Leg::kR2, LegJoint::kThoracoCoxal)];
  EXPECT_NEAR(degrees(hind_t.min_rad), -40, 1e-9);
  EXPECT_NEAR(degrees(hind_t.max_rad), 40, 1e-9);
}

TEST(Beetle, MirrorsItsJoints) {
  const RobotModel model = beetle();
  for (std::size_t joint = 0; joint < 3; ++joint) {
    for (std::size_t row = 0; row < 3; ++row) {
      const Joint& left = model.joints[6 * joint + row];
      const Joint& right = model.joints[6 * joint + row + 3];
      EXPECT_EQ(left.min_rad, right.min_rad);
      EXPECT_EQ(left.max_rad, right.max_rad);
      EXPECT_EQ(left.kp_nm_rad, right.kp_nm_rad);
    }
  }
}

TEST(ClippedToRanges, KeepsWhatFitsAndMovesWhatDoesNot) {
  RobotModel model = beetle();
  model.joints[kBackboneSlot].present = false;
  JointVector angles{};
  angles.fill(9.0);
  angles[0] = 0.1;
  const JointVector clipped = clipped_to_ranges(model, angles);
  EXPECT_EQ(clipped[0], 0.1);
  for (std::size_t slot = 1; slot < kBackboneSlot; ++slot) {
    EXPECT_EQ(clipped[slot], model.joints[slot].max_rad);
  }
  EXPECT_EQ(clipped[kBackboneSlot], 0.0) << "an absent joint";
}

}  // namespace
}  // namespace scarab::robot
