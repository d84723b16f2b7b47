#pragma once

#include <chrono>
#include <optional>

#include "common/bus/reader.hpp"
#include "common/bus/topics.hpp"
#include "common/runtime/status_publisher.hpp"
#include "tests/system/trajectory.hpp"

namespace scarab::test {

/// Sees a trial with reliable readers of its own, whatever becomes of the logger. To the stack it
/// is logger/1, so that nobody starts, nor starts anew, before it is matched; and it must be looked
/// with until the trial has started.
class Witness {
 public:
  Witness();

  /// Takes in what has come; returns all so far.
  const Trajectory& look();
  /// The newest tick; -1 before the first.
  std::int64_t tick();

 private:
  template <class T>
  void take(bus::Reader<T>& reader);
  [[nodiscard]] bool matched() const;
  [[nodiscard]] bool settled();

  bus::Participant participant_;
  runtime::StatusPublisher status_;
  bus::Reader<scarab_Trial> trials_;
  bus::Reader<scarab_RobotState> states_;
  bus::Reader<scarab_RobotState> sensors_;
  bus::Reader<scarab_Behaviour> behaviours_;
  bus::Reader<scarab_JointCommand> commands_;
  bus::Reader<scarab_NeuralActivity> activities_;
  bus::Reader<scarab_WorldState> worlds_;
  std::uint32_t trial_ = 0;
  std::optional<std::chrono::steady_clock::time_point> matched_since_;
  Trajectory seen_;
};

}  // namespace scarab::test
