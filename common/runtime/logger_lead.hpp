#pragma once

#include <algorithm>
#include <cstdint>

#include "common/bus/profile.hpp"

namespace scarab::runtime {

/// Ticks beside the lead whose samples a writer still keeps: the running one, and the last one's
/// samples that leave with it.
inline constexpr std::uint32_t kTicksBesideTheLead = 2;

/// Samples of a stream a tick, so that a writer keeps those of a lead of one tick at least.
inline constexpr unsigned kMostSamplesPerTick = bus::kStreamDepth / (kTicksBesideTheLead + 1);

/// Lockstep: ticks that the chain may be ahead of who is to get every sample, so that nothing he
/// has not received yet is overwritten in a writer's history. `samples_per_tick` is 1 to
/// kMostSamplesPerTick.
constexpr std::uint32_t lead_over_logger(unsigned samples_per_tick) {
  return std::min(bus::kDepth, bus::kStreamDepth / samples_per_tick) - kTicksBesideTheLead;
}

}  // namespace scarab::runtime
