#include "common/sample/cdr_rules.hpp"

#include <algorithm>

namespace scarab::sample {

bool is_delimited(const StructType& type) {
  return type.extensibility == Extensibility::kAppendable;
}

bool is_delimited(const ArrayType& type) {
  const Type& element = resolve(*type.element);
  if (const auto* inner = std::get_if<ArrayType>(&element.kind)) return is_delimited(*inner);
  return !std::holds_alternative<Primitive>(element.kind);
}

bool is_delimited(const SequenceType& type) {
  return !std::holds_alternative<Primitive>(resolve(*type.element).kind);
}

bool needs_xcdr2(const Type& type) {
  const Type& plain = resolve(type);
  if (const auto* array = std::get_if<ArrayType>(&plain.kind)) return needs_xcdr2(*array->element);
  if (const auto* sequence = std::get_if<SequenceType>(&plain.kind)) {
    return needs_xcdr2(*sequence->element);
  }
  const auto* structure = std::get_if<StructType>(&plain.kind);
  if (structure == nullptr) return false;
  return is_delimited(*structure) ||
         std::any_of(structure->members.begin(), structure->members.end(),
                     [](const Member& member) { return needs_xcdr2(*member.type); });
}

}  // namespace scarab::sample
