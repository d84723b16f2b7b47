#pragma once

#include <string>
#include <vector>

#include "common/runtime/options.hpp"
#include "common/runtime/trial_options.hpp"

namespace scarab::drive {

struct DriveOptions {
  runtime::BusOptions bus;
  std::vector<std::string> strategies;  ///< of the menu
  bool start_trial = false;             ///< at once, if none runs
  runtime::TrialOptions trial;          ///< of the trials started here
};

/// A standing robot without a goal, for as long as somebody may want to drive it.
runtime::TrialOptions trial_to_drive_in();

/// Drives until the person quits; returns the exit code: kExitBadUsage, with a sentence, without a
/// terminal or with one that is too small.
int drive(const DriveOptions& options);

}  // namespace scarab::drive
