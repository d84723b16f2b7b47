#pragma once

#include <ostream>

#include "common/mcap/reader.hpp"

namespace scarab::log {

/// Prints what a log holds: whether it was closed, its size, time span, trials, topics with counts
/// and rates, attachments and metadata.
void print_info(const mcap::Reader& reader, std::ostream& out);

/// Prints one line to `out` when the log was not closed, or is damaged: what is missing and that
/// `recover` mends it.
void warn_if_cut(const mcap::Reader& reader, std::ostream& out);

}  // namespace scarab::log
