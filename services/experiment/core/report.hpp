#pragma once

#include <string>
#include <vector>

#include "services/experiment/core/outcome.hpp"

/// Texts that a person or a table reads; no I/O.
namespace scarab::experiment {

/// `   12.3 s  mode 1     object 0.53 m  41 x real time`, no newline.
std::string progress_line(const Progress& progress);

/// `    2.3 s  climb      BS 0.153 rad > 0.150 rad`, no newline.
std::string change_line(const BehaviourChange& change);

/// `result: success after 20.8 s: ...`, no newline.
std::string result_line(const Outcome& outcome);

/// `9 of 10 trials succeeded; time of the successes 19.2 .. 22.1 s, median 20.4 s`, no newline.
std::string summary_line(const std::vector<Outcome>& outcomes);

/// Header and one row a trial, RFC 4180.
std::string results_csv(const std::vector<Outcome>& outcomes);

/// True if there is no failure among them.
bool all_succeeded(const std::vector<Outcome>& outcomes);

}  // namespace scarab::experiment
