#include "tests/unit/robot_bridge/serial/pseudo_terminal.hpp"

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

namespace scarab::test {
namespace {

void require(bool fine, const char* what) {
  if (!fine) throw std::system_error(errno, std::generic_category(), what);
}

}  // namespace

PseudoTerminal::PseudoTerminal() : master_(posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
  require(master_ >= 0, "posix_openpt");
  require(grantpt(master_) == 0 && unlockpt(master_) == 0, "unlockpt");
  path_ = ptsname(master_);
}

PseudoTerminal::~PseudoTerminal() { unplug(); }

void PseudoTerminal::write(const Bytes& bytes) {
  std::size_t written = 0;
  while (written < bytes.size()) {
    const ssize_t step = ::write(master_, bytes.data() + written, bytes.size() - written);
    require(step > 0, "write to a pseudo-terminal");
    written += static_cast<std::size_t>(step);
  }
}

Bytes PseudoTerminal::read(std::size_t size, std::chrono::milliseconds within) {
  const auto deadline = std::chrono::steady_clock::now() + within;
  Bytes bytes(size);
  std::size_t taken = 0;
  while (taken < size) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
        deadline - std::chrono::steady_clock::now());
    pollfd request{master_, POLLIN, 0};
    if (poll(&request, 1, std::max(0, static_cast<int>(left.count()))) <= 0) break;
    const ssize_t step = ::read(master_, bytes.data() + taken, size - taken);
    if (step <= 0) break;
    taken += static_cast<std::size_t>(step);
  }
  bytes.resize(taken);
  return bytes;
}

void PseudoTerminal::unplug() {
  if (master_ >= 0) close(std::exchange(master_, -1));
}

}  // namespace scarab::test
