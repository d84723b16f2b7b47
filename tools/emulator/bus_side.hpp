#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/bus/reader.hpp"
#include "common/bus/topics.hpp"
#include "common/bus/writer.hpp"
#include "services/plant/core/world_truth.hpp"

namespace scarab::emulator {

/// What the emulator has to do with the bus: it learns which trial to build a world for, and tells
/// what a camera above the laboratory would see. Nothing else: nobody of the stack can tell it from
/// a robot.
class BusSide {
 public:
  /// Throws bus::Error when the bus cannot be joined.
  explicit BusSide(const bus::ParticipantOptions& options);

  /// The newest trial that was told since the last call; one that is running already is none.
  std::optional<scarab_Trial> take_trial();
  /// Publishes scarab/world_state. Throws bus::Error.
  void publish(std::uint32_t trial, std::uint32_t tick, std::int64_t time_ns,
               const plant::WorldTruth& truth);

 private:
  bus::Participant participant_;
  bus::Reader<scarab_Trial> trials_;
  bus::Writer<scarab_WorldState> worlds_;
  std::vector<scarab_Contact> contacts_;
  std::uint32_t trial_ = 0;
};

}  // namespace scarab::emulator
