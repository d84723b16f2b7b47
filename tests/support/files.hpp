#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace scarab::test {

/// An empty directory of its own, removed with the object.
class TemporaryDirectory {
 public:
  TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  ~TemporaryDirectory();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path operator/(std::string_view name) const {
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

/// The bytes of a file; empty if there is none.
std::string read_text(const std::filesystem::path& path);

/// Throws std::runtime_error naming the path.
void write_text(const std::filesystem::path& path, std::string_view text);

}  // namespace scarab::test
