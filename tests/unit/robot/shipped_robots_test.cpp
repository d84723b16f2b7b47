// What the files of one robot must agree on, for every robot in config/robot.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "common/config/robot_file.hpp"
#include "common/robot/joint_limits.hpp"
#include "common/robot/leg_kinematics.hpp"
#include "common/robot/mass.hpp"
#include "services/plant/config.hpp"
#include "services/plant/core/scene.hpp"
#include "services/premotor/config.hpp"
#include "services/premotor/core/premotor_network.hpp"
#include "services/supervisor/config.hpp"

namespace scarab::robot {
namespace {

constexpr int kTicks = 20000;
constexpr double kTwoPi = 6.283185307179586476925;

std::string file(const std::string& folder, const std::string& robot) {
  return SCARAB_SOURCE_DIR "/config/" + folder + "/" + robot + ".yaml";
}

std::vector<std::string> shipped_robots() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(SCARAB_SOURCE_DIR "/config/robot")) {
    names.push_back(entry.path().stem());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// The feet's lowest points in the trunk's frame, m.
std::vector<Eigen::Vector3d> foot_points(const RobotModel& model, const JointVector& angles_rad) {
  std::vector<Eigen::Vector3d> points;
  for (const Leg leg : kLegs) {
    points.push_back(foot_position_m(model, leg, leg_angles(model, leg, angles_rad)));
    points.back().z() -= model.rows[row(leg)].foot_radius_m;
  }
  return points;
}

/// A level line through the feet as seen from the side, z = height + slope x, and how far the
/// farthest foot is off it.
struct Stance {
  double height_m = 0;
  double slope = 0;
  double off_m = 0;
};

Stance stance(const std::vector<Eigen::Vector3d>& feet) {
  double x = 0, z = 0, xx = 0, xz = 0;
  for (const auto& foot : feet) {
    x += foot.x() / 6;
    z += foot.z() / 6;
    xx += foot.x() * foot.x() / 6;
    xz += foot.x() * foot.z() / 6;
  }
  Stance out;
  out.slope = (xz - x * z) / (xx - x * x);
  out.height_m = z - out.slope * x;
  for (const auto& foot : feet) {
    out.off_m = std::max(out.off_m, std::abs(foot.z() - out.height_m - out.slope * foot.x()));
  }
  return out;
}

/// Mean period of the oscillator, ticks.
double cpg_period_ticks(const premotor::NetworkConfig& config, const std::array<double, 2>& start) {
  const premotor::PremotorNetwork network(config);
  premotor::NetworkState state;
  state.cpg = start;
  double turned = 0;
  for (int i = 0; i < kTicks; ++i) {
    const double before = std::atan2(state.cpg[1], state.cpg[0]);
    state = network.step(state, {0, 1, 0, 0});
    turned += std::remainder(std::atan2(state.cpg[1], state.cpg[0]) - before, kTwoPi);
  }
  return kTwoPi * kTicks / std::abs(turned);
}

class ShippedRobot : public testing::TestWithParam<std::string> {
 protected:
  const RobotModel model_ = config::load_robot(file("robot", GetParam()));
  const plant::PlantConfig plant_ = plant::load_config(file("plant", GetParam()));
  const premotor::PremotorConfig premotor_ = premotor::load_config(file("premotor", GetParam()));
  const supervisor::SupervisorConfig supervisor_ =
      supervisor::load_config(file("supervisor", GetParam()));
};

TEST_P(ShippedRobot, IsCalledAsItsFile) { EXPECT_EQ(model_.name, GetParam()); }

TEST_P(ShippedRobot, StartsOnItsFeet) {
  const JointVector start = plant::start_targets(plant_.start);
  const Stance found = stance(foot_points(model_, start));
  double thinnest_m = 1;
  for (const auto& row : model_.rows) thinnest_m = std::min(thinnest_m, row.foot_radius_m);
  EXPECT_LT(found.off_m, thinnest_m) << "a foot hangs higher than it is thick";
  EXPECT_LT(std::abs(found.slope), 0.1) << "the trunk settles along the line of the feet";
  EXPECT_LT(found.height_m + std::abs(found.slope) * model_.trunk.length_m / 2,
            -model_.trunk.height_m / 2)
      << "the trunk would lie on the ground";
}

TEST_P(ShippedRobot, StartsInsideItsRanges) {
  const JointVector start = plant::start_targets(plant_.start);
  for (std::size_t slot = 0; slot < kJointCount; ++slot) {
    if (!model_.joints[slot].present) continue;
    EXPECT_EQ(clipped_to_range(model_.joints[slot], start[slot]), start[slot]) << kJointNames[slot];
  }
}

TEST_P(ShippedRobot, StartsWhereItsMotorNeuronsRest) {
  const auto expect_offsets = [](const std::array<double, 3>& start,
                                 const premotor::MotorRowConfig& motor) {
    EXPECT_EQ(start[0], motor.t_offset_rad);
    EXPECT_EQ(start[1], motor.c_offset_rad);
    EXPECT_EQ(start[2], motor.f_offset_rad);
  };
  expect_offsets(plant_.start.front_rad, premotor_.motor.front);
  expect_offsets(plant_.start.middle_rad, premotor_.motor.middle);
  expect_offsets(plant_.start.hind_rad, premotor_.motor.hind);
  EXPECT_EQ(plant_.start.backbone_rad, supervisor_.backbone_rad);
}

TEST_P(ShippedRobot, IsWatchedByASupervisorThatKnowsItsStanceAndRhythm) {
  EXPECT_EQ(supervisor_.as.reference_rad, premotor_.motor.front.f_offset_rad);
  const auto& network = premotor_.network;
  EXPECT_NEAR(supervisor_.as.window_ticks, cpg_period_ticks(network, network.cpg.start_output),
              0.05);
}

INSTANTIATE_TEST_SUITE_P(Config, ShippedRobot, testing::ValuesIn(shipped_robots()),
                         [](const auto& robot) { return robot.param; });

RobotModel phantomx() { return config::load_robot(file("robot", "phantomx")); }

TEST(Phantomx, WeighsWhatItsPartsWeigh) {
  // 18 servos of 54.6 g, 18 links of 24.4 g and 0.65 kg of body, battery and electronics.
  EXPECT_NEAR(total_mass_kg(phantomx()), 18 * 0.0546 + 18 * 0.0244 + 0.648, 0.01);
}

TEST(Phantomx, HasEighteenJointsAndNoBackbone) {
  const RobotModel model = phantomx();
  for (std::size_t slot = 0; slot < kJointCount; ++slot) {
    EXPECT_EQ(model.joints[slot].present, slot != kBackboneSlot) << kJointNames[slot];
  }
}

TEST(Phantomx, StandsLevel) {
  const JointVector start =
      plant::start_targets(plant::load_config(file("plant", "phantomx")).start);
  const RobotModel model = phantomx();
  const Stance found = stance(foot_points(model, start));
  EXPECT_LT(found.off_m + std::abs(found.slope), 1e-9) << "its legs are alike";
}

TEST(Phantomx, IsAnotherRobotThanTheBeetle) {
  const RobotModel model = phantomx();
  const RobotModel beetle = config::load_robot(file("robot", "beetle"));
  EXPECT_LT(total_mass_kg(model), 0.5 * total_mass_kg(beetle));
  for (std::size_t i = 0; i < model.rows.size(); ++i) {
    EXPECT_NE(model.rows[i].tibia.length_m, beetle.rows[i].tibia.length_m);
    EXPECT_NE(model.rows[i].mount_yaw_rad, beetle.rows[i].mount_yaw_rad);
  }
  EXPECT_NE(model.joints[0].torque_max_nm, beetle.joints[0].torque_max_nm);
}

}  // namespace
}  // namespace scarab::robot
