#include "tools/topic/output.hpp"

#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <limits>
#include <system_error>
#include <utility>

namespace scarab::topic {
namespace {

constexpr std::size_t kPiece = 1U << 16U;
// A pipe that is ready takes this much without blocking (PIPE_BUF on Linux).
constexpr std::size_t kNeverBlocks = 4096;
constexpr int kPatienceMs = 100;

}  // namespace

Output::Output(std::function<bool()> interrupted) : interrupted_(std::move(interrupted)) {}

void Output::write(std::string_view text) {
  pending_ += text;
  if (pending_.size() >= kPiece) flush();
}

void Output::flush() {
  std::size_t done = 0;
  while (done < pending_.size() && !closed_ && wait_until_writable()) {
    const std::size_t size = std::min(pending_.size() - done, kNeverBlocks);
    const ssize_t written = ::write(STDOUT_FILENO, pending_.data() + done, size);
    if (written > 0) done += static_cast<std::size_t>(written);
    if (written >= 0 || errno == EINTR || errno == EAGAIN) continue;
    closed_ = true;
    if (errno != EPIPE) {  // a disk that is full is no reader that has enough
      throw std::system_error(errno, std::generic_category(), "cannot write the output");
    }
  }
  pending_.clear();
}

bool Output::wait_until_writable() {
  pollfd out{STDOUT_FILENO, POLLOUT, 0};
  while (::poll(&out, 1, kPatienceMs) <= 0) {
    if (interrupted_()) {
      closed_ = true;
      return false;
    }
  }
  return true;
}

bool Output::closed() {
  pollfd out{STDOUT_FILENO, 0, 0};
  if (::poll(&out, 1, 0) > 0 && (out.revents & (POLLERR | POLLHUP | POLLNVAL)) != 0) closed_ = true;
  return closed_;
}

bool Output::is_terminal() { return ::isatty(STDOUT_FILENO) == 1; }

std::size_t Output::width() {
  if (const char* columns = std::getenv("COLUMNS")) {
    char* end = nullptr;
    const unsigned long said = std::strtoul(columns, &end, 10);
    if (end != columns && *end == '\0' && said <= std::numeric_limits<std::uint16_t>::max()) {
      return said;
    }
  }
  winsize size{};
  if (!is_terminal() || ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0) return 0;
  return size.ws_col;
}

}  // namespace scarab::topic
