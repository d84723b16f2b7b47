#include "services/robot_bridge/drivers/amosii/protocol/values.hpp"

#include <algorithm>
#include <cmath>

#include "services/robot_bridge/drivers/amosii/protocol/slots.hpp"

namespace scarab::bridge::amosii {
namespace {

/// The nearest byte that does not end a frame. (NaN becomes 1.)
std::uint8_t to_byte(double value) {
  return static_cast<std::uint8_t>(std::lround(std::fmin(std::fmax(value, 1.0), 255.0)));
}

}  // namespace

std::uint8_t motor_byte(std::size_t joint, double m) {
  const MotorSlot& servo = kMotorSlots[joint];
  const double trimmed = std::clamp(m + servo.trim, -1.0, 1.0);
  return static_cast<std::uint8_t>((trimmed + 1.0) / 2.0 * (servo.high - servo.low) + servo.low);
}

double motor_command(std::size_t joint, std::uint8_t byte) {
  const MotorSlot& servo = kMotorSlots[joint];
  const double middle = byte + 0.5;
  const double trimmed = (middle - servo.low) / (servo.high - servo.low) * 2.0 - 1.0;
  return std::clamp(trimmed, -1.0, 1.0) - servo.trim;
}

double effective_command(std::size_t joint, double m) {
  const double trim = kMotorSlots[joint].trim;
  return std::clamp(m + trim, -1.0, 1.0) - trim;
}

double motor_command_for(const JointCalibration& c, double joint_rad) {
  return 2.0 * (to_servo_rad(c, joint_rad) - c.min_rad) / (c.max_rad - c.min_rad) - 1.0;
}

double joint_angle_for(const JointCalibration& c, double m) {
  return to_joint_rad(c, c.min_rad + (m + 1.0) / 2.0 * (c.max_rad - c.min_rad));
}

double foot_load(std::size_t leg, std::uint8_t byte) {
  const FootSlot& foot = kFootSlots[leg];
  const double span = foot.high - foot.low;
  return std::clamp((byte - foot.low) / span, 0.0, 1.0);
}

std::uint8_t foot_byte(std::size_t leg, double load) {
  const FootSlot& foot = kFootSlots[leg];
  return to_byte(foot.low + std::clamp(load, 0.0, 1.0) * (foot.high - foot.low));
}

double measured(const LinearInput& input, std::uint8_t byte) {
  return (byte - input.zero_byte) * input.per_byte;
}

std::uint8_t input_byte(const LinearInput& input, double value) {
  return to_byte(input.zero_byte + value / input.per_byte);
}

}  // namespace scarab::bridge::amosii
