#pragma once

#include <array>
#include <cstddef>
#include <string_view>

/// Joint and leg slots: the one order of every 19- and 6-element array in the project
/// (idl/scarab/header.idl). Signs: T + forward, C + up, F + flexion (down), backbone + rear up.
/// Angle 0 on T and C is a leg straight out sideways.
namespace scarab::robot {

inline constexpr std::size_t kJointCount = 19;
inline constexpr std::size_t kLegCount = 6;
inline constexpr std::size_t kBackboneSlot = 18;

/// Legs in slot order: index 0 front, 1 middle, 2 hind, left before right.
enum class Leg : std::size_t { kL0, kL1, kL2, kR0, kR1, kR2 };

/// Joints of a leg from the trunk outwards: thoraco-coxal, coxa-trochanteral, femur-tibia.
enum class LegJoint : std::size_t { kThoracoCoxal, kCoxaTrochanteral, kFemurTibia };

inline constexpr std::array<Leg, kLegCount> kLegs = {Leg::kL0, Leg::kL1, Leg::kL2,
                                                     Leg::kR0, Leg::kR1, Leg::kR2};

/// One number for each joint slot.
using JointVector = std::array<double, kJointCount>;
/// One number for each leg slot.
using LegVector = std::array<double, kLegCount>;

constexpr std::size_t leg_slot(Leg leg) { return static_cast<std::size_t>(leg); }
constexpr bool is_left(Leg leg) { return leg_slot(leg) < 3; }
/// 0 front, 1 middle, 2 hind.
constexpr std::size_t row(Leg leg) { return leg_slot(leg) % 3; }
/// +1 for the tripod {L0, R1, L2}, -1 for {R0, L1, R2}.
constexpr double tripod_sign(Leg leg) { return is_left(leg) == (row(leg) != 1) ? 1.0 : -1.0; }

constexpr std::size_t joint_slot(Leg leg, LegJoint joint) {
  return 6 * static_cast<std::size_t>(joint) + leg_slot(leg);
}

/// Paper names in slot order: TL0..TL2, TR0..TR2, CL0.., CR0.., FL0.., FR0.., BJ.
inline constexpr std::array<std::string_view, kJointCount> kJointNames = {
    "TL0", "TL1", "TL2", "TR0", "TR1", "TR2", "CL0", "CL1", "CL2", "CR0",
    "CR1", "CR2", "FL0", "FL1", "FL2", "FR0", "FR1", "FR2", "BJ"};

inline constexpr std::array<std::string_view, kLegCount> kLegNames = {"L0", "L1", "L2",
                                                                      "R0", "R1", "R2"};

}  // namespace scarab::robot
