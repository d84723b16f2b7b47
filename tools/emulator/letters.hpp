#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/robot/joints.hpp"
#include "services/plant/core/simulation.hpp"
#include "services/plant/core/world_truth.hpp"
#include "tools/emulator/faults/fault.hpp"

namespace scarab::emulator {

/// Where somebody wants joints to stand when a trial begins; none: as configured.
using Pose = std::array<std::optional<double>, robot::kJointCount>;

/// What the laboratory tells the robot.
struct Orders {
  std::vector<FaultOrder> faults;
  std::uint32_t trial = 0;                   ///< of the world
  std::unique_ptr<plant::Simulation> world;  ///< none: the old one stays
  bool end = false;
};

/// Something that has happened at the robot, for the journal.
struct Event {
  std::int64_t stamp_ns = 0;  ///< wall clock
  std::string name;
  std::string detail;
};

/// What a camera above it saw.
struct Sight {
  std::uint32_t trial = 0;
  std::int64_t time_ns = 0;  ///< of the world
  plant::WorldTruth truth;
};

/// What the robot tells the laboratory.
struct Report {
  std::vector<Event> events;
  std::vector<Sight> sights;
  std::optional<Pose> pose;  ///< where it has changed
  /// A world that has been replaced, for who has the time to take it apart.
  std::unique_ptr<plant::Simulation> old_world;
  bool ended = false;

  [[nodiscard]] bool is_empty() const {
    return events.empty() && sights.empty() && !pose && !old_world && !ended;
  }
};

}  // namespace scarab::emulator
