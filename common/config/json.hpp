#pragma once

#include <string>
#include <string_view>

#include "common/config/value.hpp"

namespace scarab::config {

/// JSON text of a value: plain scalars that are numbers or truth values as such, every other scalar
/// as a string, nothing as null. What fits a line stands on one.
[[nodiscard]] std::string emit_json(const Value& value);

/// Text as a JSON string.
[[nodiscard]] std::string in_json_quotes(std::string_view text);

}  // namespace scarab::config
