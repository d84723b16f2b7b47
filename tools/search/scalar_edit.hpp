#pragma once

#include <string>
#include <vector>

#include "common/config/error.hpp"

/// Changes to a YAML file by hand's measure: what a person would type, and nothing else moves.
namespace scarab::search {

/// Replaces the plain scalar `before`, which stands at `position`, by `after`.
struct ScalarEdit {
  config::Position position;
  std::string before;
  std::string after;
};

/// The text with all edits made. A comment behind a changed value stays in its column if there is
/// room for that. Throws std::invalid_argument if one is not where it is said to be.
[[nodiscard]] std::string edit_scalars(const std::string& text, std::vector<ScalarEdit> edits);

/// The text with this block of comment lines (each beginning with `#`) below its first line, in
/// place of the block that was there before.
[[nodiscard]] std::string with_provenance(const std::string& text,
                                          const std::vector<std::string>& lines);

}  // namespace scarab::search
