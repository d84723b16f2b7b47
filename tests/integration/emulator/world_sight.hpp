#pragma once

#include <optional>
#include <vector>

#include "common/bus/clock.hpp"
#include "common/bus/reader.hpp"
#include "common/bus/sample_fields.hpp"
#include "common/bus/topics.hpp"
#include "common/bus/writer.hpp"
#include "tests/support/eventually.hpp"
#include "tests/support/test_bus.hpp"

namespace scarab::test {

/// Tells trials, and sees what becomes of the world.
class WorldSight {
 public:
  struct Seen {
    scarab_Header header;
    double trunk_height_m;
    bool obstacle;
    scarab_Verdict verdict;
  };

  [[nodiscard]] bool is_met() const {
    return !worlds_.matched().empty() && !trials_.matched().empty();
  }
  void tell_trial(std::uint32_t number, double time_limit_s = 1000, double obstacle_m = 0) {
    scarab_Trial trial{};
    trial.header.trial = number;
    trial.header.stamp_ns = bus::now_ns();
    bus::assign(trial.strategy, "stand");
    trial.goal = scarab_GOAL_NONE;
    trial.time_limit_s = time_limit_s;
    trial.obstacle_height_m = obstacle_m;
    trial.seed = number;
    trials_.write(trial);
  }
  const std::vector<Seen>& all() {
    worlds_.take([this](const scarab_WorldState& world) {
      seen_.push_back(
          {world.header, world.trunk.position_m[2], world.obstacle_present, world.verdict});
    });
    return seen_;
  }
  /// The first sight from now on for which the condition holds.
  template <class Condition>
  std::optional<Seen> await(Condition&& condition) {
    std::size_t next = all().size();
    std::optional<Seen> found;
    eventually([&] {
      const auto& seen = all();
      for (; next < seen.size() && !found; ++next) {
        if (condition(seen[next])) found = seen[next];
      }
      return found.has_value();
    });
    return found;
  }
  /// The first of a trial, however long ago.
  std::optional<Seen> first_of(std::uint32_t trial) {
    std::optional<Seen> found;
    eventually([&] {
      for (const Seen& seen : all()) {
        if (!found && seen.header.trial == trial) found = seen;
      }
      return found.has_value();
    });
    return found;
  }

 private:
  bus::Participant participant_{test_options("laboratory")};
  bus::Writer<scarab_Trial> trials_{participant_, bus::kTrial};
  bus::Reader<scarab_WorldState> worlds_{participant_, bus::kWorldState};
  std::vector<Seen> seen_;
};

}  // namespace scarab::test
