#pragma once

#include <ostream>

#include "tools/log/facts.hpp"

namespace scarab::log {

/// Prints what a log holds: its files, time span, trials and their pace, topics with counts, rates,
/// writers and QoS, what was dropped, attachments and metadata.
void print_info(const LogFacts& facts, std::ostream& out);

/// The same as one JSON object. Times in ns are strings: they are beyond what a double holds.
void print_info_json(const LogFacts& facts, std::ostream& out);

/// Prints one line to `out` for each file that was not closed, or is damaged: what is missing and
/// that `recover` mends it.
void warn_if_cut(const Log& log, std::ostream& out);

}  // namespace scarab::log
