#include "services/robot_bridge/drivers/dynamixel/servo_health.hpp"

#include <algorithm>

namespace scarab::bridge::dynamixel {
namespace {

constexpr std::size_t kThings = 2;  // asked in turn: temperature and torque

/// "81 C": a servo's thermometer knows whole degrees.
std::string degrees(double temperature_c) {
  return std::to_string(static_cast<int>(temperature_c)) + " C";
}

}  // namespace

void ServoHealth::look(ServoGroup& servos, const std::vector<Status>& feedback, bool powered) {
  take_alerts(feedback);
  const auto unknown = std::find_if(states_.begin(), states_.end(), [](const State& state) {
    return state.alert && state.hardware_error == 0;
  });
  if (unknown != states_.end()) {
    const auto index = static_cast<std::size_t>(unknown - states_.begin());
    unknown->hardware_error =
        static_cast<std::uint8_t>(servos.read_one(index, &ServoModel::hardware_error_status));
    return;
  }
  const std::size_t index = next_ / kThings;
  State& state = states_[index];
  if (next_ % kThings == 0) {
    const double unit = servos.servos()[index].model.present_temperature.unit;
    const auto count = servos.read_one(index, &ServoModel::present_temperature);
    state.temperature_c = static_cast<double>(count) * unit;
  } else {
    state.torque_lost = powered && servos.read_one(index, &ServoModel::torque_enable) == 0;
  }
  next_ = (next_ + 1) % (kThings * states_.size());
}

void ServoHealth::take_alerts(const std::vector<Status>& feedback) {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    states_[i].alert = feedback[i].alert;
    if (!states_[i].alert) states_[i].hardware_error = 0;
  }
}

void ServoHealth::report(const ServoGroup& servos, Readings& readings) const {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    readings.temperature_c[servos.servos()[i].joint] = states_[i].temperature_c;
    const std::string error = error_of(i);
    if (error.empty()) continue;
    readings.device_error +=
        (readings.device_error.empty() ? "" : "; ") + name_of(servos.servos()[i]) + ": " + error;
  }
}

std::string ServoHealth::error_of(std::size_t index) const {
  const State& state = states_[index];
  if (state.hardware_error != 0) return hardware_error_text(state.hardware_error);
  if (state.alert) return "reports an error of its own";
  if (state.temperature_c >= limits_[index].temperature_c) {
    return degrees(state.temperature_c) + ", its own limit is " +
           degrees(limits_[index].temperature_c);
  }
  if (state.torque_lost) return "has lost its torque (was its power away?)";
  return "";
}

}  // namespace scarab::bridge::dynamixel
