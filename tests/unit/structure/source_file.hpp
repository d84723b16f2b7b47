#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace scarab::structure {

/// One #include line.
struct Include {
  int line = 0;
  std::string target;   ///< between the brackets or quotes
  bool angled = false;  ///< <target> rather than "target"
};

/// A C++ file as the rules see it.
struct SourceFile {
  std::string path;  ///< from the source root, with forward slashes
  int lines = 0;
  std::vector<Include> includes;
  std::vector<std::string> code;  ///< by line, without comments and without the content of literals

  [[nodiscard]] bool is_in(std::string_view folder) const;
  /// First, second, ... component of the path; empty if there is none.
  [[nodiscard]] std::string part(std::size_t index) const;
  [[nodiscard]] std::string file_name() const;
};

/// A file from its text.
[[nodiscard]] SourceFile parse_source(std::string path, const std::string& text);

/// All .hpp, .h and .cpp files in these folders of `root`, sorted by path.
[[nodiscard]] std::vector<SourceFile> read_tree(const std::filesystem::path& root,
                                                const std::vector<std::string>& folders);

/// Parts of a path between slashes.
[[nodiscard]] std::vector<std::string> parts_of(const std::string& path);

}  // namespace scarab::structure
