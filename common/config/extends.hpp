#pragma once

#include <cstddef>
#include <filesystem>

#include "common/config/document.hpp"

/// A file may begin with `extends: other.yaml`, a path relative to the file's own folder: what it
/// does not give then comes from there, and what that one does not give from the file it extends.
///
/// Maps are merged key by key, at every depth. Anything else replaces what the base has, whatever
/// kind it is of: a list is replaced whole, and `absent` takes the place of a map as a map takes
/// the place of `absent`. Whether the outcome fits is asked of the whole, once, by the reader. A
/// key of the base cannot be taken away.
namespace scarab::config {

inline constexpr std::size_t kMostBases = 8;  ///< a chain longer than this is refused

/// Reads and parses a file together with the files it extends. Every value keeps the file, line and
/// column where it stands. Throws Error as parse_file() does, and at `extends` if it is not the
/// first key, does not name a file that is there, leads back to a file of the chain, or makes the
/// chain too long.
[[nodiscard]] Document read_extended(const std::filesystem::path& path);

}  // namespace scarab::config
