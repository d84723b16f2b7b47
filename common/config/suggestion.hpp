#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace scarab::config {

/// Fewest insertions, deletions, substitutions and swaps of neighbours that turn `a` into `b` (the
/// Damerau-Levenshtein distance in its optimal string alignment form).
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The name nearest to `text`, if it is near enough to be meant: up to a third of the length, at
/// least 2 edits.
[[nodiscard]] std::optional<std::string_view> closest(std::string_view text,
                                                      const std::vector<std::string_view>& names);

}  // namespace scarab::config
