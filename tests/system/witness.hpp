#pragma once

#include <chrono>
#include <optional>

#include "common/bus/reader.hpp"
#include "common/bus/topics.hpp"
#include "common/runtime/status_publisher.hpp"
#include "tests/system/trajectory.hpp"

namespace scarab::test {

/// Sees a trial with reliable readers of its own, whatever becomes of the logger. To the stack it
/// is logger/1: nobody starts, or starts anew, before it is matched, and lockstep does not run
/// ahead of it. So it must look again and again as long as the trial runs.
class Witness {
 public:
  Witness();

  /// Takes in what has come, and says so; returns all so far.
  const Trajectory& look();
  /// The newest tick; -1 before the first.
  std::int64_t tick();
  /// It has the answers to the tick before the newest, or to the newest: it lags behind nobody.
  bool caught_up();

 private:
  template <class T>
  void take(bus::Reader<T>& reader);
  [[nodiscard]] std::int64_t newest(const std::string& topic) const;
  [[nodiscard]] bool matched() const;
  [[nodiscard]] bool settled();
  void report();

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
