#include "tools/emulator/wire/pseudo_terminal.hpp"

#include <fcntl.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace scarab::emulator {
namespace {

[[noreturn]] void fail(const char* what) {
  throw std::runtime_error(std::string(what) + ": " + std::strerror(errno));
}

void close_if_open(int& fd) noexcept {
  if (fd >= 0) ::close(std::exchange(fd, -1));
}

/// Bytes as they are, no echo: until the other side sets the line up itself.
termios raw_settings() {
  termios settings{};
  ::cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD;
  return settings;
}

}  // namespace

PseudoTerminal::PseudoTerminal(const std::filesystem::path& link) : link_(link) { plug(); }

PseudoTerminal::~PseudoTerminal() { unplug(); }

void PseudoTerminal::plug() {
  if (is_plugged()) return;
  const termios settings = raw_settings();
  std::array<char, 128> name{};
  if (::openpty(&board_side_, &port_side_, name.data(), &settings, nullptr) != 0) {
    board_side_ = port_side_ = -1;
    fail("no pseudo-terminal");
  }
  ::fcntl(board_side_, F_SETFL, O_NONBLOCK);
  ::fcntl(board_side_, F_SETFD, FD_CLOEXEC);
  ::fcntl(port_side_, F_SETFD, FD_CLOEXEC);
  try {
    link_.point_to(name.data());
  } catch (...) {
    close_if_open(port_side_);
    close_if_open(board_side_);
    throw;
  }
}

void PseudoTerminal::unplug() noexcept {
  link_.remove();
  close_if_open(port_side_);
  close_if_open(board_side_);
}

std::vector<std::uint8_t> PseudoTerminal::read() {
  std::array<std::uint8_t, 4096> buffer{};
  if (!is_plugged()) return {};
  const ssize_t count = ::read(board_side_, buffer.data(), buffer.size());
  if (count <= 0) return {};
  return {buffer.begin(), buffer.begin() + count};
}

std::size_t PseudoTerminal::write(const std::vector<std::uint8_t>& bytes) {
  if (!is_plugged() || bytes.empty()) return 0;
  const ssize_t count = ::write(board_side_, bytes.data(), bytes.size());
  return count < 0 ? 0 : static_cast<std::size_t>(count);
}

}  // namespace scarab::emulator
