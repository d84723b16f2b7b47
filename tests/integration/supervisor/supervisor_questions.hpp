#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "common/bus/sample_fields.hpp"
#include "common/bus/topics.hpp"

namespace scarab::test {

/// The supervisor as tests talk to it.
struct Supervisor {
  using Question = scarab_RobotState;
  using Answer = scarab_Behaviour;
  static constexpr const char* kName = "supervisor";
  static constexpr const char* kAsker = "plant";
  static constexpr std::array<const char*, 2> kReaders = {"premotor", "plant"};
  static constexpr const char* kExpect = "plant=1,premotor=1";
  static constexpr const auto& question() { return bus::kRobotState; }
  static constexpr const auto& answer() { return bus::kBehaviour; }

  static scarab_Trial trial(std::uint32_t number) {
    scarab_Trial trial{};
    trial.header.trial = number;
    bus::assign(trial.strategy, "soft+hard");
    return trial;
  }
  /// A robot that rears up slowly and moves its front legs: each answer depends on all questions
  /// before it, and the behaviour changes on the way.
  static scarab_RobotState question_of(std::uint32_t trial, std::uint32_t tick) {
    scarab_RobotState state{};
    state.header = {trial, tick, tick * 100'000'000LL, 0};
    state.phase = scarab_PHASE_RUNNING;
    for (std::size_t joint = 0; joint < std::size(state.position_rad); ++joint) {
      state.position_rad[joint] = 0.4 * std::sin(0.2 * tick + static_cast<double>(joint));
      state.position_source[joint] = scarab_SOURCE_MEASURED;
    }
    state.imu_source = scarab_SOURCE_MEASURED;
    state.inclination_rad[1] = std::min(0.02 * tick, 0.4);
    return state;
  }
  /// The same robot without joint feedback: it tells what it was told, and draws a current that
  /// rises from `blocked_tick` on.
  static scarab_RobotState blind_question_of(std::uint32_t trial, std::uint32_t tick,
                                             std::uint32_t blocked_tick) {
    scarab_RobotState state = question_of(trial, tick);
    std::fill(std::begin(state.position_source), std::end(state.position_source),
              scarab_SOURCE_COMMANDED);
    state.supply_current_a = tick < blocked_tick ? 5 : 12;
    state.supply_current_source = scarab_SOURCE_MEASURED;
    return state;
  }
};

}  // namespace scarab::test
