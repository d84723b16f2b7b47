#pragma once

#include <cstdint>

namespace scarab::logger {

/// Decides when a disk is too full to be written to, and when there is room again. What was stopped
/// goes on only with an eighth more than the limit free, at most 32 MiB, so that the two do not
/// alternate.
class DiskGuard {
 public:
  /// `keep_free_bytes` are to stay free; 0: there is always room.
  explicit DiskGuard(std::uint64_t keep_free_bytes) : keep_free_bytes_(keep_free_bytes) {}

  /// `pending_bytes` are still to be written to the disk, of which `free_bytes` are free.
  void update(std::uint64_t free_bytes, std::uint64_t pending_bytes);
  bool has_room() const { return has_room_; }
  std::uint64_t keep_free_bytes() const { return keep_free_bytes_; }

 private:
  std::uint64_t keep_free_bytes_;
  bool has_room_ = true;
};

}  // namespace scarab::logger
