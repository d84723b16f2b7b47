#pragma once

#include <string>

#include "common/config/value.hpp"

namespace scarab::config {

/// JSON text of a value: plain scalars that are numbers or truth values as such, every other scalar
/// as a string, nothing as null. What fits a line stands on one.
[[nodiscard]] std::string emit_json(const Value& value);

}  // namespace scarab::config
