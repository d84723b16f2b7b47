#include "services/plant/core/morphology.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

#include "tests/unit/plant/rig.hpp"

namespace scarab::plant {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

Morphology laid_out(const robot::RobotModel& robot) {
  return make_morphology(robot, testing::default_config().object);
}

TEST(Morphology, TakesAFirstJointInsideTheTrunk) {
  robot::RobotModel robot = testing::beetle();
  robot.rows[1].shoulder.length_m = 0;
  const Morphology morphology = laid_out(robot);
  const auto& mount = morphology.mounting[leg_body(robot::Leg::kL1, LegSegment::kCoxa)];
  for (int i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(mount.position_in_parent(i),
                     robot.rows[1].attachment_m[static_cast<std::size_t>(i)]);
  }
  EXPECT_NEAR(testing::robot_mass(morphology), testing::robot_mass(laid_out(testing::beetle())),
              1e-12)
      << "a shoulder without length still weighs";
}

TEST(Morphology, NamesASizeThatCannotBe) {
  const auto refused = [](const char* what, auto&& spoil) {
    robot::RobotModel robot = testing::beetle();
    spoil(robot);
    EXPECT_THAT([&] { laid_out(robot); }, ThrowsMessage<std::invalid_argument>(HasSubstr(what)));
  };
  refused("shoulder length", [](auto& robot) { robot.rows[0].shoulder.length_m = -0.01; });
  refused("segment length", [](auto& robot) { robot.rows[0].coxa.length_m = 0; });
  refused("segment length", [](auto& robot) { robot.rows[2].tibia.length_m = 0; });
  refused("segment radius", [](auto& robot) { robot.rows[1].femur.radius_m = 0; });
  refused("segment mass", [](auto& robot) { robot.rows[1].shoulder.mass_kg = 0; });
  refused("foot radius", [](auto& robot) { robot.rows[0].foot_radius_m = 0; });
  refused("trunk mass", [](auto& robot) { robot.trunk.mass_kg = -1; });
  refused("hinge", [](auto& robot) { robot.trunk.hinge_x_m = 1; });
}

}  // namespace
}  // namespace scarab::plant
