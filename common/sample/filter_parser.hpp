#pragma once

#include <string>
#include <vector>

#include "common/sample/field_path.hpp"
#include "common/sample/filter_condition.hpp"
#include "common/sample/type_model.hpp"

namespace scarab::sample {

/// A filter expression, and the fields it compares.
struct ParsedFilter {
  FilterCondition condition;
  std::vector<FieldPath> fields;  ///< what FilterOperand::field counts
};

/// Parses an expression over the fields of a type. Throws Error (NoSuchMember for a field that is
/// none): `column 15: reason`.
ParsedFilter parse_filter(const TypeModel& model, const std::string& expression);

}  // namespace scarab::sample
