#include "services/robot_bridge/calibrate/terminal_console.hpp"

#include <poll.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

namespace scarab::bridge::calibrate {
namespace {

Key key_of(char character) {
  switch (character) {
    case '\n':
    case '\r':
      return Key::kEnter;
    case '+':
    case '=':  // the same key without Shift
      return Key::kPlus;
    case '-':
      return Key::kMinus;
    case 's':
      return Key::kSkip;
    case 'k':
      return Key::kKeep;
    case 'q':
      return Key::kQuit;
    default:
      return Key::kNone;
  }
}

int take_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  const int fd = signalfd(-1, &signals, SFD_CLOEXEC);
  if (fd < 0) throw std::system_error(errno, std::generic_category(), "signalfd");
  return fd;
}

}  // namespace

TerminalConsole::TerminalConsole() : signals_(take_signals()) {
  termios settings{};
  if (tcgetattr(STDIN_FILENO, &settings) != 0) return;
  before_ = settings;
  settings.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  tcsetattr(STDIN_FILENO, TCSANOW, &settings);
}

TerminalConsole::~TerminalConsole() {
  if (before_) tcsetattr(STDIN_FILENO, TCSANOW, &*before_);
  close(signals_);
}

Key TerminalConsole::key(std::chrono::milliseconds longest) {
  std::array<pollfd, 2> inputs = {{{signals_, POLLIN, 0}, {STDIN_FILENO, POLLIN, 0}}};
  if (poll(inputs.data(), inputs.size(), static_cast<int>(longest.count())) <= 0) return Key::kNone;
  if (inputs[0].revents != 0) throw Interrupted();
  char character = 0;
  if (read(STDIN_FILENO, &character, 1) <= 0) return Key::kQuit;
  return key_of(character);
}

}  // namespace scarab::bridge::calibrate
