#pragma once

#include <gmock/gmock.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <exception>
#include <thread>

#include "common/bus/clock.hpp"
#include "common/runtime/tick_master.hpp"
#include "tests/integration/plant/chain_ends.hpp"
#include "tests/integration/tick_master/recording_body.hpp"
#include "tests/support/status_watch.hpp"
#include "tests/unit/safety/small_robot.hpp"

namespace scarab::test {

/// A tick master on a thread of its own, moving a RecordingBody, between the test's chain ends.
class MasterOfABody : public testing::Test {
 protected:
  using Call = RecordingBody::Call;
  struct Options {
    runtime::Pace pace = runtime::Pace::kRealTime;
    std::chrono::milliseconds tick_period{20};
    std::uint32_t stale_ticks_limit = 0;
  };
  static constexpr unsigned kSamples = 2;
  static constexpr double kHomingRadS = 0.5;

  void start(const Options& options) {
    options_ = options;
    body_.emplace(options.tick_period, kSamples);
    thread_ = std::thread([this] {
      try {
        serve();
      } catch (const std::exception& error) {
        ADD_FAILURE() << "the tick master has ended: " << error.what();
      }
    });
    EXPECT_TRUE(eventually([&] { return !operator_.matched().empty(); }));
  }
  ~MasterOfABody() override { stop(); }
  /// Ends it as a signal does.
  void stop() {
    if (!thread_.joinable()) return;
    ::kill(::getpid(), SIGTERM);
    thread_.join();
  }

  /// Tells a trial; its first state.
  std::optional<scarab_RobotState> begin(std::uint32_t trial = 1) {
    expect_trial(trial);
    ends_.tell_trial(trial);
    return ends_.states().await(trial, 0);
  }
  /// Commands `angle_rad` for every tick that comes, until a condition holds.
  template <class Condition>
  bool answer_until(double angle_rad, Condition&& condition) {
    return eventually([&] {
      answer_new(angle_rad);
      return condition();
    });
  }
  /// Somebody else tells it.
  void expect_trial(std::uint32_t trial) {
    trial_ = trial;
    answered_ = -1;
  }
  void answer_new(double angle_rad) {
    for (const scarab_RobotState& state : ends_.states().all()) {
      const auto tick = static_cast<std::int64_t>(state.header.tick);
      if (state.header.trial != trial_ || tick <= answered_) continue;
      answered_ = tick;
      scarab_JointCommand command = ChainEnds::command_for(state);
      std::fill(std::begin(command.position_rad), std::end(command.position_rad), angle_rad);
      ends_.behave(state);
      ends_.command(command);
    }
  }
  [[nodiscard]] bool applied(double angle_rad) const {
    const auto advance = body_->last(Call::kAdvance);
    return advance && std::abs(advance->target_rad - angle_rad) < 1e-9;
  }
  bool is_in(scarab_TrialPhase phase) {
    const auto& states = ends_.states().all();
    return !states.empty() && states.back().header.trial == trial_ && states.back().phase == phase;
  }

  void say(scarab_OperatorCommand command, const std::string& reason = "") {
    scarab_Operator said{};
    said.command = command;
    said.header.stamp_ns = bus::now_ns();
    bus::assign(said.reason, reason);
    operator_.write(said);
  }
  /// Its status once the message has `part`.
  bool says(const std::string& part) { return status_.await_message(self_, part).has_value(); }
  bool shows(scarab_Lifecycle lifecycle) {
    return status_.await(self_, [&](const auto& r) { return r.lifecycle == lifecycle; })
        .has_value();
  }

  const bus::Peer self_{"robot_bridge", 0};
  const runtime::SignalBlock signals_;
  StatusWatch status_;
  ChainEnds ends_;
  bus::Participant person_{test_options("operator")};
  bus::Writer<scarab_Operator> operator_{person_, bus::kOperator};
  Inbox<scarab_RobotState> sensors_{person_, bus::kRobotSensors};
  std::optional<RecordingBody> body_;

 private:
  void serve() {
    bus::Participant participant(test_options(self_.service));
    const double tick_s = std::chrono::duration<double>(options_.tick_period).count();
    safety::CommandGate gate(safety::small_robot(),
                             {tick_s, kHomingRadS, options_.stale_ticks_limit});
    runtime::ServiceOptions service;
    service.expect = {{self_.service, 1}, {"supervisor", 1}, {"premotor", 1}};
    runtime::TickMasterOptions options;
    options.pace = options_.pace;
    options.tick_period = options_.tick_period;
    options.samples_per_tick = kSamples;
    options.tells_end = true;
    runtime::TickMaster master(participant, service, self_, options, *body_, gate);
    master.run();
  }

  Options options_;
  std::thread thread_;
  std::uint32_t trial_ = 0;
  std::int64_t answered_ = -1;
};

}  // namespace scarab::test
