#pragma once

#include <optional>
#include <vector>

#include "tools/emulator/faults/fault.hpp"

namespace scarab::emulator {

/// The faults that were asked for, and which of them hold now.
///
/// One with `at` holds by the world's time, in every trial anew; one without holds from the moment
/// it was asked for, and its `for` counts by the wall clock.
class FaultPlan {
 public:
  /// What an update() has changed.
  struct Changes {
    std::vector<Fault> began;
    std::vector<Fault> ended;
    [[nodiscard]] bool any() const { return !began.empty() || !ended.empty(); }
  };

  void add(const Fault& fault, double now_s);
  void clear();

  /// `world_s` is the time since the world's t = 0; none while it stands still.
  Changes update(double now_s, std::optional<double> world_s);

  /// Those that hold, in the order they were asked for.
  [[nodiscard]] std::vector<Fault> active() const;

 private:
  struct Entry {
    Fault fault;
    double asked_s = 0;
    bool holds = false;
    bool is_over = false;
  };
  [[nodiscard]] static bool should_hold(const Entry& entry, double now_s,
                                        std::optional<double> world_s);

  std::vector<Entry> entries_;
};

}  // namespace scarab::emulator
