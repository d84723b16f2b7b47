#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "common/config/value.hpp"

namespace scarab::config {

/// A parsed file: one YAML document without duplicate keys, anchors, aliases and tags.
struct Document {
  std::string file;
  Value root;
};

/// Reads and parses a file. Throws Error if it is missing, unreadable, or no such document.
[[nodiscard]] Document parse_file(const std::filesystem::path& path);

/// Parses text; errors name it `file`.
[[nodiscard]] Document parse_text(std::string_view file, const std::string& text);

}  // namespace scarab::config
