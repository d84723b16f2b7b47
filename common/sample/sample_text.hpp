#pragma once

#include <string>

#include "common/sample/cdr_visitor.hpp"

namespace scarab::sample {

/// A value as text: numbers as short as reads back to the same, enums by name, text as it is.
std::string scalar_text(const Scalar& value);

/// A sample as YAML: nested structs indented, lists of plain values in one line.
std::string yaml_text(const TypeModel& model, ByteView cdr);

/// A sample as one line of JSON. Enums are names; numbers JSON cannot write (nan, inf) are strings.
std::string json_text(const TypeModel& model, ByteView cdr);

}  // namespace scarab::sample
