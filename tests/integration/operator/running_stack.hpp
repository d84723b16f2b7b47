#pragma once

#include <gmock/gmock.h>

#include "common/bus/clock.hpp"
#include "common/bus/sample_fields.hpp"
#include "common/bus/writer.hpp"
#include "tests/support/files.hpp"
#include "tests/support/inbox.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/status_watch.hpp"

namespace scarab::test {

/// Plant, supervisor and premotor controller, real programs in real time, and a participant that
/// hears what is said to them.
class RunningStack : public testing::Test {
 protected:
  /// A trial without goal and obstacle runs.
  void begin_trial(std::uint32_t number = 1, const std::string& strategy = "stand") {
    scarab_Trial trial{};
    trial.header.trial = number;
    trial.header.stamp_ns = bus::now_ns();
    bus::assign(trial.strategy, strategy);
    trial.goal = scarab_GOAL_NONE;
    trial.time_limit_s = 1000;
    trials_.write(trial);
    ASSERT_TRUE(behaviours_.await(number, 0)) << plant_.err() << supervisor_.err();
  }
  /// A behaviour that comes from now on, for which the condition holds.
  template <class Condition>
  std::optional<scarab_Behaviour> await_behaviour(Condition&& condition) {
    const std::size_t from = behaviours_.all().size();
    std::optional<scarab_Behaviour> found;
    eventually([&] {
      const auto& all = behaviours_.all();
      for (std::size_t i = from; i < all.size() && !found; ++i) {
        if (condition(all[i])) found = all[i];
      }
      return found.has_value();
    });
    return found;
  }

  static constexpr const char* kExpect = "plant=1,supervisor=1,premotor=1";

  TemporaryDirectory run_dir_;
  StatusWatch status_;
  bus::Participant participant_{test_options("experiment")};
  bus::Writer<scarab_Trial> trials_{participant_, bus::kTrial};
  Inbox<scarab_Behaviour> behaviours_{participant_, bus::kBehaviour};
  Inbox<scarab_Operator> said_{participant_, bus::kOperator};
  ChildProcess plant_ = start({"plant", kExpect, run_dir_.path(), 0, {"--pace", "realtime"}});
  ChildProcess supervisor_ = start({"supervisor", kExpect, run_dir_.path(), 0, {}});
  ChildProcess premotor_ = start({"premotor", kExpect, run_dir_.path(), 0, {}});
};

}  // namespace scarab::test
