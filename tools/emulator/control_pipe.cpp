#include "tools/emulator/control_pipe.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace scarab::emulator {
namespace {

/// A line that long is no order; it must not fill the memory.
constexpr std::size_t kLongestLine = 4096;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& why) {
  throw std::runtime_error(path.string() + ": " + why);
}

/// Only a pipe that is open for reading can be opened for writing alone without waiting.
bool somebody_reads(const std::filesystem::path& path) {
  const int fd = ::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
  if (fd >= 0) ::close(fd);
  return fd >= 0;
}

}  // namespace

ControlPipe::ControlPipe(std::filesystem::path path) : path_(std::move(path)) {
  if (path_.empty()) return;
  if (::mkfifo(path_.c_str(), 0600) != 0 && errno != EEXIST) fail(path_, std::strerror(errno));
  if (!std::filesystem::is_fifo(path_)) fail(path_, "there is something that is no pipe");
  if (somebody_reads(path_)) fail(path_, "another emulator takes its faults here");
  // For writing, too: then there is always a writer, and no end of file.
  fd_ = ::open(path_.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (fd_ < 0) fail(path_, std::strerror(errno));
}

ControlPipe::~ControlPipe() {
  if (fd_ < 0) return;
  ::unlink(path_.c_str());
  ::close(fd_);
}

std::vector<std::string> ControlPipe::read() {
  std::array<char, 4096> buffer{};
  const ssize_t count = fd_ < 0 ? 0 : ::read(fd_, buffer.data(), buffer.size());
  if (count > 0) begun_.append(buffer.data(), static_cast<std::size_t>(count));
  std::vector<std::string> lines;
  for (std::size_t end = 0; (end = begun_.find('\n')) != std::string::npos;) {
    lines.push_back(begun_.substr(0, end));
    begun_.erase(0, end + 1);
  }
  if (begun_.size() > kLongestLine) begun_.clear();
  return lines;
}

}  // namespace scarab::emulator
