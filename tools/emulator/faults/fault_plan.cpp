#include "tools/emulator/faults/fault_plan.hpp"

#include <algorithm>

namespace scarab::emulator {

void FaultPlan::add(const Fault& fault, double now_s) { entries_.push_back({fault, now_s}); }

void FaultPlan::clear() {
  for (Entry& entry : entries_) entry.is_over = true;
}

bool FaultPlan::should_hold(const Entry& entry, double now_s, std::optional<double> world_s) {
  if (entry.is_over) return false;
  const Fault& fault = entry.fault;
  if (fault.at_s && !world_s) return false;
  const double since_s = fault.at_s ? *world_s - *fault.at_s : now_s - entry.asked_s;
  return since_s >= 0 && (!fault.for_s || since_s < *fault.for_s);
}

FaultPlan::Changes FaultPlan::update(double now_s, std::optional<double> world_s) {
  Changes changes;
  for (Entry& entry : entries_) {
    const bool holds = should_hold(entry, now_s, world_s);
    if (holds && !entry.holds) changes.began.push_back(entry.fault);
    if (!holds && entry.holds) changes.ended.push_back(entry.fault);
    entry.holds = holds;
    // One without `at` comes once; the others come again in the next trial.
    if (!holds && !entry.fault.at_s) entry.is_over = true;
  }
  entries_.erase(std::remove_if(entries_.begin(), entries_.end(),
                                [](const Entry& entry) { return entry.is_over; }),
                 entries_.end());
  return changes;
}

std::vector<Fault> FaultPlan::active() const {
  std::vector<Fault> faults;
  for (const Entry& entry : entries_) {
    if (entry.holds) faults.push_back(entry.fault);
  }
  return faults;
}

}  // namespace scarab::emulator
