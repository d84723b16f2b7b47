#pragma once

#include <filesystem>

namespace scarab::emulator {

/// The steady name of a device that comes and goes: a symbolic link, and beside it a lock
/// (`<path>.lock`) that its owner holds as long as it lives.
class Link {
 public:
  /// Takes the name. A link that a dead emulator has left is replaced. Throws std::runtime_error,
  /// naming the path, if a living one has it or if something else than a link is there.
  explicit Link(std::filesystem::path path);
  ~Link();
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;

  /// In one step: the link is never half there. Throws std::runtime_error.
  void point_to(const std::filesystem::path& device);
  void remove() noexcept;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  void lock();

  std::filesystem::path path_;
  std::filesystem::path lock_path_;
  int lock_ = -1;
};

}  // namespace scarab::emulator
