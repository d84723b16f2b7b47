#pragma once

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

#include "tools/log/selection.hpp"

namespace scarab::log {

struct TableOptions {
  std::string topic;
  /// Columns (`header.tick`), or their beginnings (`position_rad` for all 19 of them); empty: all.
  std::vector<std::string> fields;
  std::size_t sequence_elements = 0;  ///< of each sequence that get columns beside its length
  bool times = false;                 ///< put log_time_ns and publish_time_ns first
};

/// Writes the messages of a topic that `selection` takes as CSV: a line with the names of the
/// columns, then one a sample in the order of the log. Enums are names. Throws
/// std::invalid_argument for a field that does not exist (what() says which there are); else as
/// mcap::Reader, and bus::Error for a message that is no sample of its type.
void write_csv(const Log& log, const Selection& selection, const TableOptions& options,
               std::ostream& out);

/// The same as a JSON array with an object a sample: the sample itself, or a key for each field.
void write_json(const Log& log, const Selection& selection, const TableOptions& options,
                std::ostream& out);

}  // namespace scarab::log
