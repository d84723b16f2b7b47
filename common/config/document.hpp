#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "common/config/value.hpp"

namespace scarab::config {

/// A parsed file: one YAML document without duplicate keys, anchors, aliases and tags. Together
/// with the files it extends it is one document of several files (extends.hpp).
struct Document {
  std::vector<std::string> files;  ///< the file itself, then those it extends, nearest first
  Value root;
};

/// Reads and parses a file, which extends none. Throws Error if it is missing, unreadable, or no
/// such document.
[[nodiscard]] Document parse_file(const std::filesystem::path& path);

/// Parses text; errors name it `file`.
[[nodiscard]] Document parse_text(std::string_view file, const std::string& text);

}  // namespace scarab::config
