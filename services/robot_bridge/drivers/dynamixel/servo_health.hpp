#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "services/robot_bridge/core/readings.hpp"
#include "services/robot_bridge/drivers/dynamixel/servo_group.hpp"
#include "services/robot_bridge/drivers/dynamixel/setup.hpp"

namespace scarab::bridge::dynamixel {

/// How the servos are: temperature, torque, errors of their own. To keep a cycle short, each look()
/// asks one servo one thing: what an alert bit means, else in turn a temperature, else in turn
/// whether a torque that was switched on still is.
class ServoHealth {
 public:
  explicit ServoHealth(std::vector<ServoLimits> limits)
      : limits_(std::move(limits)), states_(limits_.size()) {}

  /// After each feedback, with its answers. Throws what the bus throws.
  void look(ServoGroup& servos, const std::vector<Status>& feedback, bool powered);

  /// Temperatures known so far and, if a servo has an error, device_error.
  void report(const ServoGroup& servos, Readings& readings) const;

 private:
  struct State {
    double temperature_c = std::numeric_limits<double>::quiet_NaN();
    bool alert = false;
    std::uint8_t hardware_error = 0;  ///< what the alert is; 0: not asked yet
    bool torque_lost = false;         ///< it is off without having been switched off
  };

  void take_alerts(const std::vector<Status>& feedback);
  [[nodiscard]] std::string error_of(std::size_t index) const;

  std::vector<ServoLimits> limits_;
  std::vector<State> states_;
  std::size_t next_ = 0;  ///< in turn: servo 0's temperature, its torque, servo 1's temperature ...
};

}  // namespace scarab::bridge::dynamixel
