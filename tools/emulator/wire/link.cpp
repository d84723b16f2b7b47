#include "tools/emulator/wire/link.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace scarab::emulator {
namespace {

std::filesystem::path with_ending(const std::filesystem::path& path, const char* ending) {
  return path.parent_path() / (path.filename().string() + ending);
}

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& why) {
  throw std::runtime_error(path.string() + ": " + why);
}

bool is_gone(int fd) {
  struct stat status {};
  return ::fstat(fd, &status) != 0 || status.st_nlink == 0;
}

}  // namespace

Link::Link(std::filesystem::path path)
    : path_(std::move(path)), lock_path_(with_ending(path_, ".lock")) {
  const auto there = std::filesystem::symlink_status(path_).type();
  if (there != std::filesystem::file_type::not_found &&
      there != std::filesystem::file_type::symlink) {
    fail(path_, "there is something that is no link; it stays as it is");
  }
  lock();
}

Link::~Link() {
  remove();
  ::unlink(lock_path_.c_str());
  ::close(lock_);
}

/// Its owner removes the lock when it goes, so what has just been locked may be a file that nobody
/// sees any more.
void Link::lock() {
  constexpr int kTries = 10;
  for (int i = 0; i < kTries; ++i) {
    lock_ = ::open(lock_path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (lock_ < 0) fail(lock_path_, std::strerror(errno));
    const bool locked = ::flock(lock_, LOCK_EX | LOCK_NB) == 0;
    if (locked && !is_gone(lock_)) return;
    ::close(std::exchange(lock_, -1));
    if (!locked)
      fail(path_, "another emulator has this device; end it, or choose another --device");
  }
  fail(lock_path_, "cannot be locked");
}

void Link::point_to(const std::filesystem::path& device) {
  const std::filesystem::path fresh = with_ending(path_, ".new");
  std::error_code error;
  std::filesystem::remove(fresh, error);
  std::filesystem::create_symlink(device, fresh, error);
  if (!error) std::filesystem::rename(fresh, path_, error);
  if (error) fail(path_, error.message());
}

void Link::remove() noexcept {
  std::error_code error;
  std::filesystem::remove(path_, error);
}

}  // namespace scarab::emulator
