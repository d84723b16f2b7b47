#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "common/mcap/reader.hpp"

namespace scarab::log {

struct CsvOptions {
  std::string topic;
  std::optional<std::uint32_t> trial;  ///< only samples of this trial
  /// Columns (`header.tick`), or their beginnings (`position_rad` for all 19 of them); empty: all.
  std::vector<std::string> fields;
  std::size_t sequence_elements = 0;  ///< of each sequence that get columns beside its length
  bool times = false;                 ///< put log_time_ns and publish_time_ns first
};

/// Writes a topic as a table: a line with the names of the columns, then one a sample in the order
/// of the log. Enums are names. Throws std::invalid_argument for a topic or field that does not
/// exist (what() says which there are) and for a type that is none of the project's own; else as
/// mcap::Reader.
void write_csv(const mcap::Reader& reader, const CsvOptions& options, std::ostream& out);

}  // namespace scarab::log
