#pragma once

#include <cstdint>
#include <filesystem>

#include "common/mcap/bytes.hpp"

namespace scarab::mcap {

/// A regular file, read by position. Its size is the one at opening, so that a file still being
/// written can be read.
class InputFile {
 public:
  /// Throws FileError, for pipes and devices, too.
  explicit InputFile(std::filesystem::path path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  std::uint64_t size() const { return size_; }
  const std::filesystem::path& path() const { return path_; }
  /// The `length` bytes from `offset` on. Throws FileError when they are not all there.
  Bytes read(std::uint64_t offset, std::uint64_t length) const;
  /// The same into memory of the caller's, as many bytes as it has.
  void read(std::uint64_t offset, Bytes& into) const;

 private:
  void check_range(std::uint64_t offset, std::uint64_t length) const;

  std::filesystem::path path_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace scarab::mcap
