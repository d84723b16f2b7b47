#pragma once

#include "tests/unit/structure/include_rules.hpp"
#include "tests/unit/structure/source_file.hpp"

/// Rules on the text of files rather than on their includes.
namespace scarab::structure {

/// Pure files name no clock, thread, console, environment or log, and hold no variable that
/// outlives a call.
[[nodiscard]] Violations check_pure_text(const SourceFile& file);

/// Types of the IDL are seen by adapters and by what moves messages, never by cores, configuration
/// or main.cpp.
[[nodiscard]] Violations check_idl_types(const SourceFile& file);

/// Who controls the robot does not know the ground truth (scarab/world_state). One file of the
/// robot bridge reads the verdict in it, which ends the trial.
[[nodiscard]] Violations check_ground_truth(const SourceFile& file);

/// A service's main.cpp has fewer than 60 lines.
[[nodiscard]] Violations check_main_length(const SourceFile& file);

}  // namespace scarab::structure
