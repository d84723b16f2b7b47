#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "common/sample/cdr_visitor.hpp"

namespace scarab::sample {

/// What a filter compares: numbers, enum values and truth values as numbers (a long double holds
/// every 64-bit integer exactly), text and characters as text.
using FilterValue = std::variant<long double, std::string>;

/// One side of a comparison: a field or a value from the expression.
struct FilterOperand {
  std::optional<std::size_t> field;  ///< which of the fields read from the sample
  FilterValue value;                 ///< where it is no field
};

enum class FilterRelation {
  kEqual,
  kNotEqual,
  kLess,
  kLessOrEqual,
  kGreater,
  kGreaterOrEqual,
  kLike,
};

/// A filter expression as a tree.
struct FilterCondition {
  enum class Kind { kComparison, kNot, kAnd, kOr };
  Kind kind = Kind::kComparison;
  std::vector<FilterCondition> parts;  ///< of NOT one, of AND and OR two or more
  FilterOperand left;                  ///< of a comparison, of operands of the same alternative
  FilterRelation relation = FilterRelation::kEqual;
  FilterOperand right;
};

/// Whether a condition holds for the fields of a sample. A comparison with a field that is not
/// there is false.
bool holds(const FilterCondition& condition, const std::vector<std::optional<Scalar>>& fields);

}  // namespace scarab::sample
