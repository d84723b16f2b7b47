#pragma once

#include <string>

#include "common/sample/cdr_builder.hpp"
#include "common/sample/cdr_output.hpp"

namespace scarab::sample {

/// Writes a number, truth value or character given as text; nothing is zero. Throws Error with the
/// reason, such as `70000 is no short (-32768 to 32767)`.
void write_primitive(Primitive primitive, const WrittenValue& value, CdrOutput& out);

/// The value of an enum, by name or number. Throws Error with the reason, which tells the names.
std::int32_t enum_number(const EnumType& type, const WrittenValue& value);

}  // namespace scarab::sample
