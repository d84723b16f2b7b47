#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "services/robot_bridge/drivers/dynamixel/config.hpp"
#include "tests/unit/robot_bridge/dynamixel/scripted_bus.hpp"

namespace scarab::bridge::dynamixel {

/// A robot with the joints TL0, TL1, TL2: servos 1, 2, 3. TL1 runs the other way, TL2 stands off by
/// a quarter of a turn.
struct DriverRig {
  DriverRig();

  /// A driver for the line of `bus`, which plays the servos.
  [[nodiscard]] std::unique_ptr<Driver> make_driver(const ScriptedBus& bus) const;
  /// The servos of this robot, all at the middle of their scale.
  [[nodiscard]] static std::map<std::uint8_t, ScriptedDevice> devices();

  Config config;
  robot::RobotModel robot;
  Calibration calibration;
};

/// The message of the DeviceError that `call` throws; "" if it throws none.
template <class Call>
std::string device_error(Call&& call) {
  try {
    call();
  } catch (const DeviceError& error) {
    return error.what();
  }
  return "";
}

/// A counter of a driver.
std::uint64_t counter(const Driver& driver, const std::string& name);

}  // namespace scarab::bridge::dynamixel
