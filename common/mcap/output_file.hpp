#pragma once

#include <cstdint>
#include <filesystem>

#include "common/mcap/bytes.hpp"
#include "common/mcap/crc32.hpp"

namespace scarab::mcap {

/// A new file that only grows. What append() has returned from is with the operating system and
/// outlives the process.
class OutputFile {
 public:
  /// Creates `path`. Throws FileError when it cannot, or when the file exists and `overwrite` is
  /// false.
  OutputFile(std::filesystem::path path, bool overwrite);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Writes all of `bytes` or nothing: after an error the file ends where it ended before. Throws
  /// FileError.
  void append(ByteView bytes);
  /// Closes and renames to `final_path`; with `sync` after everything has reached the disk. Throws
  /// FileError.
  void finish(const std::filesystem::path& final_path, bool sync);

  std::uint64_t size() const { return size_; }
  /// CRC-32 of everything written so far.
  std::uint32_t crc() const { return crc_.value(); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
  Crc32 crc_;
};

}  // namespace scarab::mcap
