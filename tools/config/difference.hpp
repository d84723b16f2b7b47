#pragma once

#include <string>
#include <vector>

#include "common/config/value.hpp"

namespace scarab::config_tool {

/// What changes from `a` to `b`, one line for each value: `key.path: 1 -> 2`. Maps are compared key
/// by key whatever their order, everything else as a whole; a key that only one has is `(none)` on
/// the other side. Empty if they are equal.
[[nodiscard]] std::vector<std::string> differences(const config::Value& a, const config::Value& b);

}  // namespace scarab::config_tool
