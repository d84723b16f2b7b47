#pragma once

#include <cstddef>
#include <cstdint>

#include "services/robot_bridge/core/calibration.hpp"

/// Between the bytes of the slots and what they stand for.
namespace scarab::bridge::amosii {

/// The byte for motor command `m` in [-1, 1] of a joint slot:
///
///     s = int((m' + 1) / 2 * (high - low) + low),   m' = clamp(m + trim, -1, 1)
///
/// as the laboratory's software computes it: int() cuts off the fraction.
[[nodiscard]] std::uint8_t motor_byte(std::size_t joint, double m);

/// The other way, for the board's side: the middle of the m that give this byte, trim taken off.
/// At most half a byte's step from the m that was sent.
[[nodiscard]] double motor_command(std::size_t joint, std::uint8_t byte);

/// The m that `m` really has the effect of: one beyond what the trim leaves of [-1, 1] ends there.
[[nodiscard]] double effective_command(std::size_t joint, double m);

/// The m for an angle (rad) of the joint: -1 and +1 are the ends of the servo's travel.
///
/// A reconstruction: the laboratory publishes which m its controllers send and which bytes they
/// become, but no angle for either. Its simulation spreads m over each joint's range, with the
/// signs of T and C opposite to the project's; so the calibration's travel, direction and offset
/// say what the real servos do.
[[nodiscard]] double motor_command_for(const JointCalibration& c, double joint_rad);
/// The joint's angle (rad) for m.
[[nodiscard]] double joint_angle_for(const JointCalibration& c, double m);

/// Load of a foot, 0 (off the ground) to 1 (full), from its input; clipped to that.
[[nodiscard]] double foot_load(std::size_t leg, std::uint8_t byte);
/// The other way, rounded to the nearest byte.
[[nodiscard]] std::uint8_t foot_byte(std::size_t leg, double load);

/// An analogue input that grows in a straight line with what it measures.
struct LinearInput {
  double zero_byte = kMiddleByte;
  double per_byte = 0;  ///< in the unit of what is measured; negative: falls as that grows

  static constexpr double kMiddleByte = 128;
};

[[nodiscard]] double measured(const LinearInput& input, std::uint8_t byte);
/// The other way, rounded to the nearest byte from 1 to 255; `per_byte` not 0.
[[nodiscard]] std::uint8_t input_byte(const LinearInput& input, double value);

}  // namespace scarab::bridge::amosii
