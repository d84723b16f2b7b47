#include "common/config/robot_file.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "common/config/error.hpp"
#include "tests/unit/config/error_line.hpp"

namespace scarab::config {
namespace {

using robot::Leg;
using robot::LegJoint;

std::string beetle_text() {
  std::ifstream file(SCARAB_SOURCE_DIR "/config/robot/beetle.yaml");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The beetle's file with the first `from` replaced, which must be there.
std::string beetle_but(const std::string& from, const std::string& to) {
  std::string text = beetle_text();
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("not in beetle.yaml: " + from);
  return text.replace(at, from.size(), to);
}

/// The error of a robot file without its line and column, which change with the file's comments;
/// that they are there is checked.
std::string error_of(const std::string& text) {
  try {
    (void)load_robot_text("r.yaml", text);
  } catch (const Error& error) {
    return key_and_reason(error.what(), "r.yaml")
        .value_or("malformed: " + std::string(error.what()));
  }
  return "no error";
}

TEST(RobotFile, NamesWhatIsMissing) {
  const std::string text = beetle_text();
  EXPECT_EQ(error_of(text.substr(0, text.find("  hind:"))), "legs.hind: missing key");
  EXPECT_EQ(error_of(text.substr(0, text.find("legs:"))), "legs: missing key");
  EXPECT_EQ(error_of(beetle_but("    foot_radius_m: 0.015", "")),
            "legs.front.foot_radius_m: missing key");
  EXPECT_EQ(error_of(beetle_but("coxa: {length_m: 0.035, ", "coxa: {")),
            "legs.front.coxa.length_m: missing key");
}

TEST(RobotFile, NamesWhatIsWrong) {
  EXPECT_EQ(error_of(beetle_but("kd_nm_s_rad: 0.8", "kd_nm_s_rad: .nan")),
            "servos.leg.kd_nm_s_rad: '.nan' is not finite");
  EXPECT_EQ(error_of(beetle_but("{length_m: 0.035", "{length_m: 35")),
            "legs.front.coxa.length_m: 35 is not in [0, 2]");
  EXPECT_EQ(error_of(beetle_but("min_rad: 0.0 ", "min_rad: 1.6 ")),
            "legs.front.joints.femur_tibia.min_rad: 1.6 is not below max_rad, which is "
            "1.5707963267948966");
  EXPECT_EQ(error_of(beetle_but("servo: leg\n", "servo: lge\n")),
            "legs.front.joints.thoraco_coxal.servo: no servo 'lge' in this file's servos; did you "
            "mean 'leg'?");
  EXPECT_EQ(error_of(beetle_but("hinge_x_m: 0.095", "hinge_x_m: 0.3")),
            "trunk.hinge_x_m: the hinge must be inside the trunk, within +-0.215 of its centre");
  EXPECT_EQ(error_of(beetle_but("on_front_segment: true", "on_front_segment: false")),
            "legs.front.on_front_segment: must be true: the mount is before the backbone hinge");
  EXPECT_EQ(error_of(beetle_but("[0.175, 0.035", "[0.175, -0.035")),
            "legs.front.attachment_m: the mount is the left leg's: its y must be at least 0");
}

TEST(RobotFile, CanSayThatAJointIsAbsent) {
  std::string text = beetle_text();
  const std::size_t backbone = text.find("\nbackbone:");
  text.replace(backbone, text.find("\n#", backbone) - backbone, "\nbackbone: absent\n");
  const std::size_t tibia = text.rfind("femur_tibia:");
  text.replace(tibia, std::string::npos, "femur_tibia: absent\n");
  const robot::RobotModel model = load_robot_text("r.yaml", text);
  EXPECT_FALSE(model.joints[robot::kBackboneSlot].present);
  EXPECT_FALSE(model.joints[joint_slot(Leg::kL2, LegJoint::kFemurTibia)].present);
  EXPECT_FALSE(model.joints[joint_slot(Leg::kR2, LegJoint::kFemurTibia)].present);
  EXPECT_TRUE(model.joints[joint_slot(Leg::kR1, LegJoint::kFemurTibia)].present);
  EXPECT_EQ(dump_robot(load_robot_text("dump", dump_robot(model))), dump_robot(model));
}

TEST(RobotFile, DumpReadsBackToAnEqualModel) {
  const robot::RobotModel model = load_robot_text("r.yaml", beetle_text());
  const robot::RobotModel again = load_robot_text("dump", dump_robot(model));
  EXPECT_EQ(again.name, model.name);
  EXPECT_EQ(again.trunk.mass_kg, model.trunk.mass_kg);
  for (std::size_t slot = 0; slot < robot::kJointCount; ++slot) {
    EXPECT_EQ(again.joints[slot].min_rad, model.joints[slot].min_rad);
    EXPECT_EQ(again.joints[slot].max_rad, model.joints[slot].max_rad);
    EXPECT_EQ(again.joints[slot].kp_nm_rad, model.joints[slot].kp_nm_rad);
    EXPECT_EQ(again.joints[slot].torque_max_nm, model.joints[slot].torque_max_nm);
  }
  for (std::size_t row = 0; row < 3; ++row) {
    EXPECT_EQ(again.rows[row].mount_yaw_rad, model.rows[row].mount_yaw_rad);
    EXPECT_EQ(again.rows[row].attachment_m[0], model.rows[row].attachment_m[0]);
    EXPECT_EQ(again.rows[row].tibia.mass_kg, model.rows[row].tibia.mass_kg);
  }
}

TEST(RobotFile, DumpRefusesAModelAFileCannotSay) {
  robot::RobotModel model = load_robot_text("r.yaml", beetle_text());
  model.joints[joint_slot(Leg::kR1, LegJoint::kThoracoCoxal)].max_rad = 0.1;
  EXPECT_THROW((void)dump_robot(model), std::invalid_argument);
}

}  // namespace
}  // namespace scarab::config
