#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "common/sample/cdr_visitor.hpp"

namespace scarab::sample {

/// How samples of a type become rows of a table.
struct ColumnOptions {
  /// Elements of each sequence that get columns; beside them a sequence has one column with its
  /// length.
  std::size_t sequence_elements = 0;
};

/// The names of the columns of a type: `header.tick`, `position_rad[3]`, `contacts.length`,
/// `contacts[0].force_n[2]`. Throws Error for more than a million.
std::vector<std::string> column_names(const TypeModel& model, const ColumnOptions& options = {});

/// A sample's values, one a column of column_names() with the same options; empty where a sequence
/// is shorter. Enums by name. Throws Error as visit_sample.
std::vector<std::string> column_values(const TypeModel& model, ByteView cdr,
                                       const ColumnOptions& options = {});

}  // namespace scarab::sample
