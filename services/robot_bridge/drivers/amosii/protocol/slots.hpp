#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "common/robot/joints.hpp"

/// Which numbered slot of the board's frames belongs to what.
///
/// Source, here and in the other headers of this folder: the figures of the laboratory's public
/// serial interface to AMOS II's second board (amosIIserialv2 of its gorobots software, 2012); the
/// board has no public manual. What that software does not show is called a reconstruction.
namespace scarab::bridge::amosii {

/// Slots are numbered from 1 in both directions, as on the board.
inline constexpr std::size_t kSlotCount = 32;

/// One byte for each slot of a frame.
struct Slots {
  std::array<std::uint8_t, kSlotCount> bytes{};

  /// `slot` from 1.
  [[nodiscard]] constexpr std::uint8_t& operator[](std::size_t slot) { return bytes[slot - 1]; }
  [[nodiscard]] constexpr std::uint8_t operator[](std::size_t slot) const {
    return bytes[slot - 1];
  }
};

/// What an output carries that moves no servo, and an analogue input at half its range.
inline constexpr std::uint8_t kMiddle = 128;

constexpr Slots all_slots(std::uint8_t byte) {
  Slots slots;
  for (std::uint8_t& each : slots.bytes) each = byte;
  return slots;
}

/// The output of one joint's servo. The laboratory commands it by m in [-1, 1].
struct MotorSlot {
  std::size_t slot = 0;
  std::uint8_t low = 0;   ///< the byte for m = -1
  std::uint8_t high = 0;  ///< the byte for m = +1; smaller than `low` where the servo is mirrored
  /// Added to m before it is clamped to [-1, 1]: the coxa-trochanteral servos' horns sit so.
  double trim = 0;
};

inline constexpr double kCoxaTrim = -0.1;

/// In the project's order of joints.
inline constexpr std::array<MotorSlot, robot::kJointCount> kMotorSlots = {{
    {21, 9, 243},             // TL0
    {29, 9, 243},             // TL1
    {11, 9, 243},             // TL2
    {22, 243, 6},             // TR0
    {26, 243, 6},             // TR1
    {12, 243, 6},             // TR2
    {19, 250, 6, kCoxaTrim},  // CL0
    {28, 6, 250, kCoxaTrim},  // CL1
    {9, 6, 250, kCoxaTrim},   // CL2
    {23, 6, 250, kCoxaTrim},  // CR0
    {30, 250, 6, kCoxaTrim},  // CR1
    {13, 250, 6, kCoxaTrim},  // CR2
    {20, 75, 245},            // FL0
    {27, 186, 7},             // FL1
    {10, 189, 6},             // FL2
    {24, 180, 10},            // FR0
    {25, 61, 241},            // FR1
    {14, 60, 243},            // FR2
    {1, 250, 1},              // BJ
}};

/// The input of one foot's force sensor.
struct FootSlot {
  std::size_t slot = 0;
  std::uint8_t low = 0;   ///< the byte of a foot off the ground
  std::uint8_t high = 0;  ///< the byte of a foot that carries what one calls full
};

/// In the project's order of legs.
inline constexpr std::array<FootSlot, robot::kLegCount> kFootSlots = {{
    {14, 40, 100},  // L0
    {12, 30, 130},  // L1
    {10, 40, 110},  // L2
    {13, 15, 90},   // R0
    {11, 60, 120},  // R1
    {9, 30, 110},   // R2
}};

inline constexpr std::size_t kInclinometerXSlot = 8;  ///< about the walking direction: roll
inline constexpr std::size_t kInclinometerYSlot = 7;  ///< about the sideways direction: pitch
inline constexpr std::size_t kMotorCurrentSlot = 29;  ///< of all motors together

/// The rest of what the board measures, nothing of which is in the project's messages.
inline constexpr std::size_t kUltrasonicRightSlot = 1;
inline constexpr std::size_t kUltrasonicLeftSlot = 2;
inline constexpr std::array<std::size_t, robot::kLegCount> kInfraredSlots = {25, 26, 18,   // L0-L2
                                                                             27, 28, 30};  // R0-R2
inline constexpr std::array<std::size_t, 3> kLightSlots = {23, 15, 32};  ///< middle, right, left

/// Whether a servo hangs on this output; the others always carry kMiddle.
constexpr bool is_motor_slot(std::size_t slot) {
  for (const MotorSlot& motor : kMotorSlots) {
    if (motor.slot == slot) return true;
  }
  return false;
}

/// Whether this input is known never to read 0: those whose published minimum is 1 or more (feet,
/// ultrasonic, infrared, light). Of the inclinometer, the current and the unused inputs no minimum
/// is published.
constexpr bool is_never_zero(std::size_t slot) {
  for (const FootSlot& foot : kFootSlots) {
    if (foot.slot == slot) return true;
  }
  for (const std::size_t infrared : kInfraredSlots) {
    if (infrared == slot) return true;
  }
  for (const std::size_t light : kLightSlots) {
    if (light == slot) return true;
  }
  return slot == kUltrasonicRightSlot || slot == kUltrasonicLeftSlot;
}

}  // namespace scarab::bridge::amosii
