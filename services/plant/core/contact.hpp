#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <cstdint>

#include "services/plant/core/bodies.hpp"
#include "services/plant/core/contact_geometry.hpp"
#include "services/plant/core/world_truth.hpp"

namespace scarab::plant {

/// Body index of ground and obstacle, which do not move.
inline constexpr std::size_t kWorldBody = kBodyCount;

constexpr bool is_leg(Solid solid) { return solid >= Solid::kCoxa; }

/// A solid and the leg it belongs to (leg slot; 0 where it is no part of a leg).
struct SolidId {
  Solid solid = Solid::kGround;
  std::uint16_t leg = 0;
  std::size_t body = kWorldBody;
};

/// Two solids touching at a point.
struct Contact {
  SolidId a;
  SolidId b;
  Touch touch;
  std::size_t feature = 0;  ///< the same for the same pair and place in every step; < kFeatureCount
};

inline constexpr std::size_t kPlacesPerPair = 8;
inline constexpr std::size_t kSolidSlots = 8 * robot::kLegCount;
inline constexpr std::size_t kFeatureCount = kSolidSlots * kSolidSlots * kPlacesPerPair;

/// Feature number of `place` (< kPlacesPerPair) of a pair of solids.
constexpr std::size_t feature(const SolidId& a, const SolidId& b, std::size_t place) {
  const std::size_t slot_a = static_cast<std::size_t>(a.solid) * robot::kLegCount + a.leg;
  const std::size_t slot_b = static_cast<std::size_t>(b.solid) * robot::kLegCount + b.leg;
  return (slot_a * kSolidSlots + slot_b) * kPlacesPerPair + place;
}

}  // namespace scarab::plant
