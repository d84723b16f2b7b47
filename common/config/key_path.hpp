#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Dotted paths of keys, such as `legs.front.attachment_m[2]`; the empty path is the top level.
namespace scarab::config {

inline std::string join_key(const std::string& path, std::string_view key) {
  return path.empty() ? std::string(key) : path + "." + std::string(key);
}

inline std::string join_index(const std::string& path, std::size_t index) {
  return path + "[" + std::to_string(index) + "]";
}

/// As it stands in an error.
inline std::string shown_path(const std::string& path) {
  return path.empty() ? "(top level)" : path;
}

}  // namespace scarab::config
