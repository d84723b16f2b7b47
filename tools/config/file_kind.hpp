#pragma once

#include <array>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace scarab::config_tool {

/// A kind of configuration file: whom it configures, which is also the name of its folder below
/// config/.
struct FileKind {
  std::string_view name;
  /// Reads and validates a file; returns it as one YAML text with every key. Throws config::Error.
  std::string (*resolve)(const std::filesystem::path& file);
  std::string (*schema)();  ///< JSON Schema of such files
};

inline constexpr std::size_t kKindCount = 7;

/// All kinds, in the order of their names.
[[nodiscard]] const std::array<FileKind, kKindCount>& file_kinds();

/// Their names: "logger, plant, ...".
[[nodiscard]] std::string kind_names();

/// A kind that is unknown, cannot be seen from a file's folder, or does not go with the other
/// files. what() is one line.
class WrongKind : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The kind of that name. Throws WrongKind.
[[nodiscard]] const FileKind& kind_named(std::string_view name);

/// The kind that a file's folder is named after. Throws WrongKind.
[[nodiscard]] const FileKind& kind_of(const std::filesystem::path& file);

}  // namespace scarab::config_tool
