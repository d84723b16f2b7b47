#include "services/logger/core/disk_guard.hpp"

#include <algorithm>

namespace scarab::logger {

void DiskGuard::update(std::uint64_t free_bytes, std::uint64_t pending_bytes) {
  constexpr std::uint64_t kMostMargin = std::uint64_t{32} << 20U;
  const std::uint64_t margin = has_room_ ? 0 : std::min(keep_free_bytes_ / 8, kMostMargin);
  has_room_ = keep_free_bytes_ == 0 || free_bytes >= keep_free_bytes_ + pending_bytes + margin;
}

}  // namespace scarab::logger
