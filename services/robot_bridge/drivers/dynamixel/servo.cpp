#include "services/robot_bridge/drivers/dynamixel/servo.hpp"

#include <cmath>
#include <stdexcept>

namespace scarab::bridge::dynamixel {

std::vector<Servo> servos_of(const Config& config, const robot::RobotModel& robot,
                             const Calibration& calibration) {
  const Calibration own = of_robot(calibration, robot);
  std::vector<Servo> servos;
  for (std::size_t joint = 0; joint < robot::kJointCount; ++joint) {
    if (!own.joints[joint]) continue;
    const std::string name(robot::kJointNames[joint]);
    const auto found = config.servos.find(name);
    if (found == config.servos.end()) {
      throw std::invalid_argument("dynamixel.servos: joint " + name + " of " + robot.name +
                                  " has no servo");
    }
    const auto model = find_model(config, found->second.model);
    if (!model) throw std::invalid_argument("dynamixel: no such model: " + found->second.model);
    servos.push_back({joint, found->second.id, *model, *own.joints[joint]});
  }
  return servos;
}

std::string name_of(const Servo& servo) {
  return "joint " + std::string(robot::kJointNames[servo.joint]);
}

std::int64_t goal_ticks(const Servo& servo, double joint_rad) {
  const double servo_rad = to_servo_rad(servo.calibration, joint_rad);
  return servo.model.centre_ticks + std::llround(servo_rad / servo.model.goal_position.unit);
}

double joint_rad(const Servo& servo, std::int64_t ticks) {
  const double servo_rad =
      static_cast<double>(ticks - servo.model.centre_ticks) * servo.model.present_position.unit;
  return to_joint_rad(servo.calibration, servo_rad);
}

}  // namespace scarab::bridge::dynamixel
