#include "services/plant/config.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <string>

#include "common/config/error.hpp"
#include "tests/unit/plant/rig.hpp"

namespace scarab::plant {
namespace {

/// A file of its own for each test process, removed with the object.
class File {
 public:
  explicit File(const std::string& text)
      : path_(::testing::TempDir() + "plant-" + std::to_string(::getpid()) + ".yaml") {
    std::ofstream(path_) << text;
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() { std::filesystem::remove(path_); }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// config/plant/beetle.yaml with the first `from` replaced by `to`.
std::string shipped_with(const std::string& from, const std::string& to) {
  std::ostringstream all;
  all << std::ifstream(SCARAB_SOURCE_DIR "/config/plant/beetle.yaml").rdbuf();
  std::string text = all.str();
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// Key and reason with which the changed file is refused; empty if it is not.
std::string refusal(const std::string& from, const std::string& to) {
  const File file(shipped_with(from, to));
  try {
    static_cast<void>(load_config(file.path()));
    return "";
  } catch (const config::Error& error) {
    const std::string line = error.what();
    return line.substr(line.find(": ") + 2);
  }
}

const std::string kJointPosition =
    "joint_position: {noise_rad: 0.0, bias_rad: 0.0, quantum_rad: 0.0, latency_s: 0.0, "
    "dropout: 0.0}";

std::string joint_position(const std::string& latency, const std::string& dropout,
                           const std::string& noise = "0.0") {
  return "joint_position: {noise_rad: " + noise +
         ", bias_rad: 0.002, quantum_rad: 0.001, latency_s: " + latency + ", dropout: " + dropout +
         "}";
}

TEST(PlantConfig, ShippedSensorsAndCommandsAreIdeal) {
  PlantConfig config = testing::default_config();
  for (const SensorErrors& errors :
       {SensorErrors(config.sensors.joint_position), SensorErrors(config.sensors.joint_velocity),
        SensorErrors(config.sensors.joint_torque), SensorErrors(config.sensors.foot_force),
        SensorErrors(config.sensors.inclination), SensorErrors(config.sensors.angular_velocity),
        SensorErrors(config.sensors.acceleration), SensorErrors(config.sensors.supply_current)}) {
    EXPECT_EQ(errors.noise + errors.bias + errors.quantum + errors.latency_s + errors.dropout, 0);
  }
  EXPECT_EQ(config.commands.latency_s + config.commands.jitter_s, 0);
}

TEST(PlantConfig, ErrorsOfASensorAreReadAndDumped) {
  const File file(shipped_with(kJointPosition, joint_position("0.02", "0.25", "0.01")));
  const PlantConfig config = load_config(file.path());
  const File dumped(dump_config(config));
  const SensorErrors again = load_config(dumped.path()).sensors.joint_position;
  EXPECT_EQ(again.noise, 0.01);
  EXPECT_EQ(again.bias, 0.002);
  EXPECT_EQ(again.quantum, 0.001);
  EXPECT_EQ(again.latency_s, 0.02);
  EXPECT_EQ(again.dropout, 0.25);
}

TEST(PlantConfig, LatenciesAreWholeNumbersOfSteps) {
  EXPECT_EQ(refusal(kJointPosition, joint_position("0.003", "0.0")),
            "sensors.joint_position.latency_s: must be a whole number of steps (timing.step_s)");
  EXPECT_EQ(refusal("jitter_s: 0.0", "jitter_s: 0.005"),
            "commands.jitter_s: must be a whole number of steps (timing.step_s)");
}

/// A writer keeps so many samples of a stream, and lockstep waits for the logger by whole ticks.
TEST(PlantConfig, ATickHasNoMoreSamplesThanTheLoggerCanBeWaitedFor) {
  const std::string control = "control_period_s: 0.1 ";
  EXPECT_EQ(refusal(control, "control_period_s: 3.4 "), "") << "170 samples";
  EXPECT_EQ(refusal(control, "control_period_s: 3.42 "),
            "timing.sensor_period_s: gives more than 170 samples a tick (control_period_s): no "
            "logger could be waited for");
}

TEST(PlantConfig, RefusesWhatNoSensorIs) {
  EXPECT_NE(refusal(kJointPosition, joint_position("0.0", "1.0")), "") << "never a sample";
  EXPECT_NE(refusal(kJointPosition, joint_position("0.0", "-0.1")), "");
  EXPECT_NE(refusal(kJointPosition, joint_position("0.6", "0.0")), "") << "too late to walk by";
  EXPECT_NE(refusal(kJointPosition, joint_position("0.0", "0.0", "-0.1")), "");
  EXPECT_NE(refusal("noise_n: 0.0", "noise_rad: 0.0"), "") << "the unit of another sensor";
  EXPECT_NE(refusal("jitter_s: 0.0", "jitter_s: 0.7"), "");
  EXPECT_EQ(refusal(kJointPosition, joint_position("0.5", "0.99")), "");
}

}  // namespace
}  // namespace scarab::plant
