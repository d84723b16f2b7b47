#pragma once

#include "common/sample/field_path.hpp"
#include "common/sample/filter_condition.hpp"
#include "common/sample/filter_tokens.hpp"

namespace scarab::sample {

/// A side of a comparison as it was written, before it is known what it is compared with.
struct WrittenOperand {
  FilterToken token;
  const FieldPath* path = nullptr;   ///< of a field
  std::optional<std::size_t> field;  ///< of a field: which one
};

/// The operand that is meant when it stands beside `other`: the name of an enum value becomes its
/// number, a number beside a 32-bit float is rounded to one. Throws Error naming the column when
/// the two cannot be compared.
FilterOperand meant_beside(const WrittenOperand& written, const WrittenOperand& other);

}  // namespace scarab::sample
