#pragma once

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <string>

#include "common/bus/sample_fields.hpp"
#include "common/bus/writer.hpp"
#include "common/runtime/status_publisher.hpp"
#include "tests/support/inbox.hpp"
#include "tests/support/test_bus.hpp"

namespace scarab::test {

/// The test's own supervisor and premotor controller around the plant, and who tells it the trial.
class ChainEnds {
 public:
  static constexpr const char* kExpect = "plant=1,supervisor=1,premotor=1";

  ChainEnds() {
    supervisor_status_.set_lifecycle(scarab_LIFECYCLE_INACTIVE);
    premotor_status_.set_lifecycle(scarab_LIFECYCLE_INACTIVE);
    say_ready(0);
  }

  /// Tells a trial without obstacle and goal, and says ready for it.
  void tell_trial(std::uint32_t number, double time_limit_s = 1000) {
    say_ready(number);
    scarab_Trial trial{};
    trial.header.trial = number;
    bus::assign(trial.strategy, "soft");
    trial.goal = scarab_GOAL_NONE;
    trial.time_limit_s = time_limit_s;
    trials_.write(trial);
  }
  void say_ready(std::uint32_t trial) {
    for (auto* status : {&supervisor_status_, &premotor_status_}) {
      status->set_ready(trial);
      status->publish_if_due();
    }
  }

  void behave(const scarab_RobotState& state) {
    scarab_Behaviour behaviour{};
    behaviour.header = state.header;
    behaviour.state = state.phase == scarab_PHASE_SUCCEEDED ? scarab_BEHAVIOUR_DONE
                      : state.phase == scarab_PHASE_FAILED  ? scarab_BEHAVIOUR_FAILED
                                                            : scarab_BEHAVIOUR_APPROACH;
    behaviours_.write(behaviour);
  }
  /// A command to stay as `state` is.
  static scarab_JointCommand command_for(const scarab_RobotState& state) {
    scarab_JointCommand command{};
    command.header = state.header;
    command.kind = scarab_COMMAND_POSITION;
    std::copy(std::begin(state.position_rad), std::end(state.position_rad),
              std::begin(command.position_rad));
    return command;
  }
  void command(const scarab_JointCommand& command) { commands_.write(command); }
  void answer(const scarab_RobotState& state) {
    behave(state);
    command(command_for(state));
  }

  /// Answers ticks first..last; the state of the tick after, if it comes to that.
  std::optional<scarab_RobotState> run(std::uint32_t trial, std::uint32_t first,
                                       std::uint32_t last) {
    for (std::uint32_t tick = first; tick <= last; ++tick) {
      const auto state = states_.await(trial, tick);
      if (!state) return std::nullopt;
      answer(*state);
    }
    return states_.await(trial, last + 1);
  }

  Inbox<scarab_RobotState>& states() { return states_; }

 private:
  bus::Participant experiment_{test_options("experiment")};
  bus::Participant supervisor_{test_options("supervisor")};
  bus::Participant premotor_{test_options("premotor")};
  bus::Writer<scarab_Trial> trials_{experiment_, bus::kTrial};
  runtime::StatusPublisher supervisor_status_{supervisor_, {"supervisor", 0}};
  runtime::StatusPublisher premotor_status_{premotor_, {"premotor", 0}};
  Inbox<scarab_RobotState> states_{supervisor_, bus::kRobotState};
  bus::Writer<scarab_Behaviour> behaviours_{supervisor_, bus::kBehaviour};
  bus::Writer<scarab_JointCommand> commands_{premotor_, bus::kJointCommand};
};

}  // namespace scarab::test
