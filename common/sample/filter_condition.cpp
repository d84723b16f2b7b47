#include "common/sample/filter_condition.hpp"

#include <algorithm>
#include <string_view>

namespace scarab::sample {

namespace {

/// A value that is not copied to be compared.
using Compared = std::variant<long double, std::string_view>;

struct ToCompared {
  Compared operator()(bool value) const { return value ? 1.0L : 0.0L; }
  Compared operator()(const char& value) const { return std::string_view(&value, 1); }
  Compared operator()(std::string_view value) const { return value; }
  Compared operator()(const EnumValue& value) const {
    return static_cast<long double>(value.value);
  }
  template <class Number>
  Compared operator()(Number value) const {
    return static_cast<long double>(value);
  }
};

/// % stands for any text, _ for any character. Goes back to the last % only, so that it takes no
/// longer than the product of the lengths.
bool is_like(std::string_view text, std::string_view pattern) {
  std::size_t at = 0;
  std::size_t in_pattern = 0;
  std::size_t after_percent = std::string_view::npos;
  std::size_t tried = 0;
  while (at < text.size()) {
    if (in_pattern < pattern.size() && pattern[in_pattern] == '%') {
      after_percent = ++in_pattern;
      tried = at;
    } else if (in_pattern < pattern.size() &&
               (pattern[in_pattern] == '_' || pattern[in_pattern] == text[at])) {
      ++in_pattern;
      ++at;
    } else if (after_percent != std::string_view::npos) {
      in_pattern = after_percent;
      at = ++tried;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('%', in_pattern) == std::string_view::npos;
}

template <class Value>
bool compare(FilterRelation relation, const Value& left, const Value& right) {
  switch (relation) {
    case FilterRelation::kEqual:
      return left == right;
    case FilterRelation::kNotEqual:
      return left != right;
    case FilterRelation::kLess:
      return left < right;
    case FilterRelation::kLessOrEqual:
      return left <= right;
    case FilterRelation::kGreater:
      return left > right;
    case FilterRelation::kGreaterOrEqual:
      return left >= right;
    case FilterRelation::kLike:
      break;  // of text only
  }
  return false;
}

std::optional<Compared> value_of(const FilterOperand& operand,
                                 const std::vector<std::optional<Scalar>>& fields) {
  if (!operand.field) {
    return std::visit([](const auto& value) { return Compared(value); }, operand.value);
  }
  const auto& field = fields.at(*operand.field);
  if (!field) return std::nullopt;
  return std::visit(ToCompared{}, *field);
}

bool comparison_holds(const FilterCondition& condition,
                      const std::vector<std::optional<Scalar>>& fields) {
  const auto left = value_of(condition.left, fields);
  const auto right = value_of(condition.right, fields);
  if (!left || !right || left->index() != right->index()) return false;
  if (const auto* text = std::get_if<std::string_view>(&*left)) {
    const auto other = std::get<std::string_view>(*right);
    if (condition.relation == FilterRelation::kLike) return is_like(*text, other);
    return compare(condition.relation, *text, other);
  }
  return compare(condition.relation, std::get<long double>(*left), std::get<long double>(*right));
}

}  // namespace

bool holds(const FilterCondition& condition, const std::vector<std::optional<Scalar>>& fields) {
  const auto part_holds = [&](const FilterCondition& part) { return holds(part, fields); };
  const auto& parts = condition.parts;
  switch (condition.kind) {
    case FilterCondition::Kind::kComparison:
      return comparison_holds(condition, fields);
    case FilterCondition::Kind::kNot:
      return !part_holds(parts.front());
    case FilterCondition::Kind::kAnd:
      return std::all_of(parts.begin(), parts.end(), part_holds);
    case FilterCondition::Kind::kOr:
      return std::any_of(parts.begin(), parts.end(), part_holds);
  }
  return false;
}

}  // namespace scarab::sample
