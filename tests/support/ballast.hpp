#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <system_error>

namespace scarab::test {

/// Takes up room on a disk as long as it lives.
class Ballast {
 public:
  /// Throws std::system_error when no file of that size can be made.
  Ballast(std::filesystem::path path, std::uint64_t bytes) : path_(std::move(path)) {
    const int file = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    const int error = file < 0 ? errno : ::posix_fallocate(file, 0, static_cast<off_t>(bytes));
    if (file >= 0) ::close(file);
    if (error != 0) {
      std::filesystem::remove(path_);
      throw std::system_error(error, std::generic_category(), "ballast " + path_.string());
    }
  }
  Ballast(const Ballast&) = delete;
  Ballast& operator=(const Ballast&) = delete;
  ~Ballast() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }

 private:
  std::filesystem::path path_;
};

}  // namespace scarab::test
