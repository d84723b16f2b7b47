#pragma once

#include <gmock/gmock.h>

#include "tests/integration/plant/chain_ends.hpp"
#include "tests/integration/plant/world_watch.hpp"
#include "tests/support/files.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/status_watch.hpp"

namespace scarab::test {

/// A plant process between the test's own chain ends.
class PlantProcess : public testing::Test {
 protected:
  explicit PlantProcess(const Arguments& more = {})
      : child_(start({"plant", ChainEnds::kExpect, run_dir_.path(), 0, more})) {}

  /// Its first state of a trial.
  std::optional<scarab_RobotState> begin(std::uint32_t trial = 1) {
    EXPECT_TRUE(eventually([&] { return world_.matched(); })) << child_.err();
    ends_.tell_trial(trial);
    auto state = ends_.states().await(trial, 0);
    EXPECT_TRUE(state) << child_.err();
    return state;
  }
  /// A counter of its status once it is `value`.
  bool counted(const std::string& counter, std::uint64_t value) {
    return status_
        .await(self_,
               [&](const auto& report) {
                 const auto entry = report.counters.find(counter);
                 return entry != report.counters.end() && entry->second == value;
               })
        .has_value();
  }
  bool healthy() { return status_.await_health(self_, scarab_HEALTH_OK).has_value(); }

  const bus::Peer self_{"plant", 0};
  TemporaryDirectory run_dir_;
  StatusWatch status_;
  WorldWatch world_;
  ChainEnds ends_;
  ChildProcess child_;
};

}  // namespace scarab::test
