#pragma once

#include <cstdint>
#include <optional>

#include "common/bus/reader.hpp"
#include "common/bus/topics.hpp"
#include "common/runtime/tick_body.hpp"

namespace scarab::bridge {

/// The verdict of whoever watches the robot from outside and publishes scarab/world_state: a
/// tracking system, or the emulator. The verdict is all that the bridge takes from the ground
/// truth; a robot that nobody watches has none.
class RefereeReader {
 public:
  explicit RefereeReader(bus::Participant& participant);

  void begin(std::uint32_t trial);
  /// Latched for this trial.
  [[nodiscard]] const std::optional<runtime::TrialEnd>& verdict();

 private:
  bus::Reader<scarab_WorldState> worlds_;
  std::uint32_t trial_ = 0;
  std::optional<runtime::TrialEnd> verdict_;
};

}  // namespace scarab::bridge
