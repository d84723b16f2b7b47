#pragma once

#include <string>

#include "common/config/value.hpp"

namespace scarab::config {

/// YAML text that parse_text() reads back to the same kinds, keys, texts and quoting.
[[nodiscard]] std::string emit(const Value& value);

}  // namespace scarab::config
