#include "common/mcap/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "common/mcap/error.hpp"

namespace scarab::mcap {
namespace {

constexpr mode_t kReadableByAll = 0644;

[[noreturn]] void fail(const std::string& action, const std::filesystem::path& path, int error) {
  throw FileError("cannot " + action + " " + path.string() + ": " +
                  std::generic_category().message(error));
}

}  // namespace

OutputFile::OutputFile(std::filesystem::path path, bool overwrite) : path_(std::move(path)) {
  const int mode = O_WRONLY | O_CREAT | O_CLOEXEC | (overwrite ? O_TRUNC : O_EXCL);
  descriptor_ = ::open(path_.c_str(), mode, kReadableByAll);
  if (descriptor_ < 0) {
    fail("create", path_, errno);
  }
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
}

void OutputFile::append(ByteView bytes) {
  std::size_t written = 0;
  while (written < bytes.size()) {
    const ssize_t result = ::write(descriptor_, bytes.data() + written, bytes.size() - written);
    if (result >= 0) {
      written += static_cast<std::size_t>(result);
    } else if (errno != EINTR) {
      const int error = errno;
      // Cut the half-written record off, so that what was closed before stands alone.
      if (::ftruncate(descriptor_, static_cast<off_t>(size_)) != 0) {
        fail("write to, nor cut back,", path_, error);
      }
      fail("write to", path_, error);
    }
  }
  size_ += bytes.size();
  crc_.update(bytes);
}

void OutputFile::finish(const std::filesystem::path& final_path, bool sync) {
  if (sync && ::fsync(descriptor_) != 0 && errno != EINVAL) {  // EINVAL: cannot be synced at all
    fail("sync", path_, errno);
  }
  if (::close(std::exchange(descriptor_, -1)) != 0) {
    fail("close", path_, errno);
  }
  std::error_code error;
  std::filesystem::rename(path_, final_path, error);
  if (error) {
    fail("rename to " + final_path.string(), path_, error.value());
  }
}

}  // namespace scarab::mcap
