#include "services/logger/disk_space.hpp"

#include <sys/statvfs.h>

#include <cerrno>

namespace scarab::logger {
namespace {

std::string in_mib(std::uint64_t bytes) { return std::to_string(bytes >> 20U) + " MiB"; }

}  // namespace

std::optional<std::uint64_t> free_bytes(const std::filesystem::path& path) {
  struct statvfs disk {};
  int result = 0;
  do {
    result = ::statvfs(path.empty() ? "." : path.c_str(), &disk);
  } while (result != 0 && errno == EINTR);
  if (result != 0) return std::nullopt;
  return static_cast<std::uint64_t>(disk.f_bavail) * disk.f_frsize;
}

bool DiskSpace::has_room(std::uint64_t pending_bytes) {
  const auto now = std::chrono::steady_clock::now();
  if (guard_.keep_free_bytes() == 0 || now - asked_ < kPeriod) return guard_.has_room();
  asked_ = now;
  const auto free = free_();
  if (!free) return guard_.has_room();
  guard_.update(*free, pending_bytes);
  if (guard_.has_room()) {
    obstacle_.clear();
  } else if (obstacle_.empty()) {  // said once: the figure would change from call to call
    obstacle_ = "disk too full to record: " + in_mib(*free) + " are free, free_disk_mib is " +
                std::to_string(guard_.keep_free_bytes() >> 20U);
  }
  return guard_.has_room();
}

}  // namespace scarab::logger
