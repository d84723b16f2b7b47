#include "services/robot_bridge/drivers/dynamixel/feedback.hpp"

#include <cmath>

namespace scarab::bridge::dynamixel {
namespace {

void measured(JointReadings& readings, std::size_t joint, double value) {
  readings.value[joint] = value;
  readings.source[joint] = Source::kMeasured;
}

/// The bytes of an item in those of the feedback region.
ByteView part(const Item& item, Region region, ByteView data) {
  return data.slice(static_cast<std::size_t>(item.address - region.address), item.size());
}

}  // namespace

Region feedback_region(const ServoGroup& servos) {
  return hull(servos.region(&ServoModel::present_current),
              hull(servos.region(&ServoModel::present_velocity),
                   servos.region(&ServoModel::present_position)));
}

void decode_feedback(const ServoGroup& servos, const std::vector<Status>& answers,
                     Readings& readings) {
  const Region region = feedback_region(servos);
  double supply_a = 0;
  for (std::size_t i = 0; i < servos.size(); ++i) {
    const Servo& servo = servos.servos()[i];
    const ServoModel& model = servo.model;
    const ByteView data = answers[i].data;
    const auto value = [&](const Item& item) { return value_in(item, part(item, region, data)); };
    const double current_a = value(model.present_current);
    const auto ticks = count_in(model.present_position, part(model.present_position, region, data));

    measured(readings.position_rad, servo.joint, joint_rad(servo, ticks));
    measured(readings.velocity_rad_s, servo.joint,
             turned(servo.calibration, value(model.present_velocity)));
    measured(readings.torque_nm, servo.joint,
             turned(servo.calibration, current_a * model.torque_constant_nm_a));
    readings.current_a[servo.joint] = current_a;
    supply_a += std::abs(current_a);
  }
  readings.supply_current_a = supply_a;
  readings.supply_current_source = Source::kMeasured;
}

Counts positions_in(const ServoGroup& servos, const std::vector<Status>& answers) {
  const Region region = feedback_region(servos);
  Counts ticks;
  for (std::size_t i = 0; i < servos.size(); ++i) {
    const Item& item = servos.servos()[i].model.present_position;
    ticks.push_back(count_in(item, part(item, region, answers[i].data)));
  }
  return ticks;
}

}  // namespace scarab::bridge::dynamixel
