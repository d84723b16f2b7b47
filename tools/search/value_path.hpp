#pragma once

#include <string>
#include <string_view>

#include "common/config/value.hpp"

namespace scarab::search {

/// The value that a dotted path leads to below `root`: keys of maps and, in lists, indices from 0,
/// such as `start.front_rad.0`. nullptr if there is none.
[[nodiscard]] const config::Value* find_value(const config::Value& root, std::string_view path);
[[nodiscard]] config::Value* find_value(config::Value& root, std::string_view path);

/// The number that stands there; throws std::invalid_argument naming `path` if there is none.
[[nodiscard]] double number_at(const config::Value& root, std::string_view path);

}  // namespace scarab::search
