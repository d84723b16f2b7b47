#include "tests/unit/robot_bridge/dynamixel/driver_rig.hpp"

#include <stdexcept>

namespace scarab::bridge::dynamixel {

constexpr double kQuarter_rad = 1.5707963267948966;

DriverRig::DriverRig() {
  config.port = "/dev/none";
  config.baud = 1000000;
  // The thread that plays the servos shares the processor with other tests.
  config.reply_timeout_s = 0.05;
  robot.name = "three joints";
  for (std::size_t joint = 0; joint < robot::kJointCount; ++joint) {
    robot.joints[joint].present = joint < 3;
  }
  for (std::size_t joint = 0; joint < 3; ++joint) {
    const std::string name(robot::kJointNames[joint]);
    config.servos[name].id = static_cast<std::uint8_t>(joint + 1);
    calibration.joints[joint] = JointCalibration{0, 1, -2, 2};
  }
  calibration.joints[1]->direction = -1;
  calibration.joints[2]->offset_rad = kQuarter_rad;
}

std::unique_ptr<Driver> DriverRig::make_driver(const ScriptedBus& bus) const {
  return make(config, robot, calibration, bus.path());
}

std::map<std::uint8_t, ScriptedDevice> DriverRig::devices() {
  return {{1, ScriptedDevice::servo()}, {2, ScriptedDevice::servo()}, {3, ScriptedDevice::servo()}};
}

std::uint64_t counter(const Driver& driver, const std::string& name) {
  for (const auto& [key, value] : driver.counters()) {
    if (key == name) return value;
  }
  throw std::invalid_argument("no counter " + name);
}

}  // namespace scarab::bridge::dynamixel
