#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "services/experiment/core/outcome.hpp"
#include "services/experiment/core/trial_line.hpp"

/// The worker protocol's lines: JSON text <-> validated values. Lines are without their newline.
namespace scarab::experiment {

/// Reads a trial line: one JSON object with every key of TrialLine, where `index` may be left out.
/// Throws config::Error, which begins with `name`, for anything else.
TrialLine read_trial_line(const std::string& name, const std::string& text);

/// The trial's keys again, then success, time_s, reason and the measures; null where a state was
/// never entered. Numbers are in the shortest form that is exact, so equal trials give equal bytes.
std::string result_row(const TrialLine& line, const Outcome& outcome);

/// `{"index": 3, "error": "..."}`; without the index where there is none.
std::string error_row(std::optional<std::uint64_t> index, const std::string& error);

}  // namespace scarab::experiment
