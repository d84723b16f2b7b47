#pragma once

#include "services/robot_bridge/core/readings.hpp"
#include "services/robot_bridge/drivers/amosii/config.hpp"
#include "services/robot_bridge/drivers/amosii/protocol/slots.hpp"
#include "services/robot_bridge/drivers/amosii/protocol/values.hpp"

/// What a reply says in SI units, and, for whoever stands in for the board, the other way.
namespace scarab::bridge::amosii {

[[nodiscard]] constexpr LinearInput input_of(const InclinationAxis& axis) {
  return {axis.zero_byte, axis.rad_per_byte};
}
[[nodiscard]] constexpr LinearInput input_of(const MotorCurrent& current) {
  return {current.zero_byte, current.a_per_byte};
}

/// Fills in foot forces, the motors' current and, if there is an inclinometer, roll and pitch. The
/// board has no gyroscope and no accelerometer: both stay absent.
void add_sensors(const Config& config, const Slots& sensors, Readings& readings);

}  // namespace scarab::bridge::amosii
