#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "services/logger/core/disk_guard.hpp"

namespace scarab::logger {

/// Bytes that may still be written where `path` is; nothing when the system does not say.
std::optional<std::uint64_t> free_bytes(const std::filesystem::path& path);

/// Keeps an eye on the disk.
class DiskSpace {
 public:
  using Free = std::function<std::optional<std::uint64_t>()>;

  /// `free` is asked at most every kPeriod; never when `keep_free_bytes` is 0.
  DiskSpace(Free free, std::uint64_t keep_free_bytes)
      : free_(std::move(free)), guard_(keep_free_bytes) {}

  /// True while what waits to be written may be.
  bool has_room(std::uint64_t pending_bytes);
  /// Why not, in words, as of the moment it began; empty while there is room.
  const std::string& obstacle() const { return obstacle_; }

 private:
  /// At 200 MB/s no more than 2 MB are written unseen; the call itself takes microseconds.
  static constexpr std::chrono::milliseconds kPeriod{10};

  Free free_;
  DiskGuard guard_;
  std::chrono::steady_clock::time_point asked_{};
  std::string obstacle_;
};

}  // namespace scarab::logger
