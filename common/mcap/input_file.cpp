#include "common/mcap/input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "common/mcap/error.hpp"

namespace scarab::mcap {

/// O_NONBLOCK: a pipe that nobody writes into is refused, not waited for.
InputFile::InputFile(std::filesystem::path path)
    : path_(std::move(path)),
      descriptor_(::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
  struct stat status {};
  std::string reason;
  if (descriptor_ < 0 || ::fstat(descriptor_, &status) != 0) {
    reason = std::generic_category().message(errno);
  } else if (!S_ISREG(status.st_mode)) {
    reason = "it is no regular file";
  }
  if (!reason.empty()) {
    if (descriptor_ >= 0) {
      ::close(descriptor_);
    }
    throw FileError("cannot open " + path_.string() + ": " + reason);
  }
  size_ = static_cast<std::uint64_t>(status.st_size);
}

InputFile::~InputFile() { ::close(descriptor_); }

/// Before memory is made for it: a length out of a damaged file may be any number.
void InputFile::check_range(std::uint64_t offset, std::uint64_t length) const {
  if (offset > size_ || length > size_ - offset) {
    throw FileError("cannot read " + path_.string() + ": it ends before byte " +
                    std::to_string(offset) + " + " + std::to_string(length));
  }
}

Bytes InputFile::read(std::uint64_t offset, std::uint64_t length) const {
  check_range(offset, length);
  Bytes bytes(static_cast<std::size_t>(length));
  read(offset, bytes);
  return bytes;
}

void InputFile::read(std::uint64_t offset, Bytes& bytes) const {
  check_range(offset, bytes.size());
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t result = ::pread(descriptor_, bytes.data() + done, bytes.size() - done,
                                   static_cast<off_t>(offset + done));
    if (result > 0) {
      done += static_cast<std::size_t>(result);
    } else if (result == 0 || errno != EINTR) {
      throw FileError(
          "cannot read " + path_.string() + ": " +
          (result == 0 ? "it has become shorter" : std::generic_category().message(errno)));
    }
  }
}

}  // namespace scarab::mcap
