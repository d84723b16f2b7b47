#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "common/config/config.hpp"
#include "common/config/robot_file.hpp"
#include "services/plant/config.hpp"
#include "services/plant/core/scene.hpp"
#include "services/robot_bridge/calibration_file.hpp"
#include "services/robot_bridge/config.hpp"
#include "services/robot_bridge/driver_choice.hpp"
#include "services/supervisor/config.hpp"

/// The files of every robot behind a bridge, and what they promise together.
namespace scarab::bridge {
namespace {

using Path = std::filesystem::path;
using testing::HasSubstr;

const Path kConfig = Path(SCARAB_SOURCE_DIR) / "config";

std::vector<Path> shipped() {
  std::vector<Path> files;
  for (const auto& entry : std::filesystem::directory_iterator(kConfig / "robot_bridge")) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

class EachBridge : public testing::TestWithParam<Path> {
 protected:
  /// Of <robot>-<driver>.yaml.
  [[nodiscard]] std::string robot_name() const {
    const std::string stem = GetParam().stem().string();
    return stem.substr(0, stem.find('-'));
  }
  [[nodiscard]] std::string driver_name() const {
    const std::string stem = GetParam().stem().string();
    return stem.substr(stem.find('-') + 1);
  }

  const BridgeConfig config_ = load_config(GetParam());
  const robot::RobotModel robot_ = config::load_robot(kConfig / "robot" / (robot_name() + ".yaml"));
  const plant::PlantConfig plant_ =
      plant::load_config(kConfig / "plant" / (robot_name() + ".yaml"));
};

TEST_P(EachBridge, IsNamedAfterItsDriver) {
  EXPECT_EQ(kDriverNames[index_of(config_.driver)], driver_name());
}

TEST_P(EachBridge, StartsAndTicksAsThePlantWhosePlaceItTakes) {
  EXPECT_EQ(joint_targets(config_.start), plant::start_targets(plant_.start));
  EXPECT_EQ(config_.timing.control_period_s, plant_.timing.control_period_s);
  // Sensors are read as often as the plant's, but where the line does not bear it.
  if (driver_name() == "amosii") {
    EXPECT_GE(config_.timing.sensor_period_s, plant_.timing.sensor_period_s);
  } else {
    EXPECT_EQ(config_.timing.sensor_period_s, plant_.timing.sensor_period_s);
  }
}

TEST_P(EachBridge, ServosReachTheRobotsWholeRange) {
  const Calibration calibration = load_calibration(config_.calibration, robot_);
  const robot::RobotModel reached = within_reach(robot_, calibration);
  for (std::size_t slot = 0; slot < robot_.joints.size(); ++slot) {
    if (!robot_.joints[slot].present) continue;
    SCOPED_TRACE(robot::kJointNames[slot]);
    EXPECT_NEAR(reached.joints[slot].min_rad, robot_.joints[slot].min_rad, 1e-9);
    EXPECT_NEAR(reached.joints[slot].max_rad, robot_.joints[slot].max_rad, 1e-9);
  }
}

/// service_status has room for 64 counters, 19 of which are the tick master's and the gate's.
TEST_P(EachBridge, HasADriverWhoseCountersFitIntoServiceStatus) {
  const Calibration calibration = load_calibration(config_.calibration, robot_);
  const auto driver = make_driver(GetParam(), config_, robot_, calibration, "/dev/null");
  ASSERT_NE(driver, nullptr);
  EXPECT_LE(driver->counters().size(), 40U);
  for (const auto& entry : driver->counters()) EXPECT_LE(entry.first.size(), 47U) << entry.first;
  EXPECT_FALSE(driver->capabilities().link.empty());
}

TEST_P(EachBridge, IsDumpedAndReadBackWhole) {
  const std::string text = dump_config(config_);
  EXPECT_EQ(dump_config(load_config_text("dumped.yaml", text)), text);
  const Calibration calibration = load_calibration(config_.calibration);
  const std::string other = dump_calibration(calibration);
  EXPECT_EQ(dump_calibration(load_calibration_text("dumped.yaml", other)), other);
}

INSTANTIATE_TEST_SUITE_P(Shipped, EachBridge, testing::ValuesIn(shipped()));

/// The supervisor's signal is the mean of two feet, each of them in the air half of the time.
TEST(BridgeConfig, AFootThatTellsOfTheObstacleIsNotCutOff) {
  const auto supervisor = supervisor::load_config(kConfig / "supervisor" / "beetle.yaml");
  const double threshold_n = supervisor.foot_force.reference_n + supervisor.foot_force.rise_n;
  const BridgeConfig config = load_config(kConfig / "robot_bridge" / "beetle-amosii.yaml");
  const auto& board = std::get<std::optional<amosii::Config>>(config.sections);
  ASSERT_TRUE(board);
  EXPECT_GT(board->foot_full_scale_n, 2 * threshold_n);
}

TEST(BridgeConfig, ADeviceThatCannotReleaseIsNotAskedTo) {
  const Path file = kConfig / "robot_bridge" / "beetle-amosii.yaml";
  BridgeConfig config = load_config(file);
  config.safe_stop = SafeStop::kRelease;
  const auto robot = config::load_robot(kConfig / "robot" / "beetle.yaml");
  const Calibration calibration = load_calibration(config.calibration, robot);
  try {
    (void)make_driver(file, config, robot, calibration, "");
    FAIL() << "taken";
  } catch (const config::Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("safe_stop: the device cannot switch its motors off"));
  }
}

}  // namespace
}  // namespace scarab::bridge
