#pragma once

#include <filesystem>
#include <string>

namespace scarab::runtime {

/// Writes a whole text file; nothing where `path` is empty. Throws std::runtime_error naming the
/// path.
void write_text(const std::filesystem::path& path, const std::string& text);

}  // namespace scarab::runtime
