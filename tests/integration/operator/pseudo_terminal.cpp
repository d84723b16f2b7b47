#include "tests/integration/operator/pseudo_terminal.hpp"

#include <fcntl.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>

namespace scarab::test {
namespace {

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// In the child: only calls that are safe after a fork of a process with threads.
[[noreturn]] void become(char* const* arguments, char* const* environment, int terminal,
                         pid_t parent) {
  constexpr int kCannotStart = 127;
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(kCannotStart);
  ::setsid();
  ::ioctl(terminal, TIOCSCTTY, 0);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(terminal, stream);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::execve(arguments[0], arguments, environment);
  ::_exit(kCannotStart);
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (auto& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// The test's own environment with another TERM.
std::vector<std::string> environment_with(const std::string& type) {
  std::vector<std::string> texts = {"TERM=" + type};
  for (char** entry = environ; *entry != nullptr; ++entry) {
    if (std::strncmp(*entry, "TERM=", 5) != 0) texts.emplace_back(*entry);
  }
  return texts;
}

bool is_graphic(char c) { return static_cast<unsigned char>(c) > 0x20 && c != 0x7F; }

/// Where the escape sequence that begins at `at` ends: CSI ... letter, or ESC, intermediates, one
/// character.
std::size_t end_of_escape(const std::string& text, std::size_t at) {
  std::size_t end = at + 1;
  if (end < text.size() && text[end] == '[') {
    ++end;
    while (end < text.size() && (text[end] < '@' || text[end] > '~')) ++end;
  } else {
    while (end < text.size() && text[end] >= ' ' && text[end] <= '/') ++end;
  }
  return std::min(end + 1, text.size());
}

std::string without_blanks(const std::string& text) {
  std::string letters;
  std::copy_if(text.begin(), text.end(), std::back_inserter(letters), is_graphic);
  return letters;
}

}  // namespace

PseudoTerminal::PseudoTerminal(const Start& start) {
  const winsize size{start.rows, start.columns, 0, 0};
  if (::openpty(&person_, &terminal_, nullptr, nullptr, &size) != 0) fail("openpty");
  ::fcntl(person_, F_SETFL, O_NONBLOCK);
  ::fcntl(person_, F_SETFD, FD_CLOEXEC);
  ::fcntl(terminal_, F_SETFD, FD_CLOEXEC);
  ::tcgetattr(terminal_, &before_);
  if (::access(start.command.front().c_str(), X_OK) != 0) fail(start.command.front().c_str());
  std::vector<std::string> command = start.command;
  std::vector<std::string> environment = environment_with(start.type);
  const auto arguments = pointers(command);
  const auto variables = pointers(environment);
  const pid_t parent = ::getpid();
  pid_ = ::fork();
  if (pid_ < 0) fail("fork");
  if (pid_ == 0) become(arguments.data(), variables.data(), terminal_, parent);
}

PseudoTerminal::~PseudoTerminal() {
  constexpr std::chrono::seconds kStopLimit{3};
  signal(SIGTERM);
  if (!wait(kStopLimit)) {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  ::close(person_);
  ::close(terminal_);
}

void PseudoTerminal::type(const std::string& keys) {
  if (::write(person_, keys.data(), keys.size()) != static_cast<ssize_t>(keys.size())) {
    fail("typing");
  }
}

void PseudoTerminal::resize(unsigned short columns, unsigned short rows) {
  const winsize size{rows, columns, 0, 0};
  ::ioctl(person_, TIOCSWINSZ, &size);  // the kernel sends SIGWINCH
}

void PseudoTerminal::signal(int number) {
  if (!exit_code_) ::kill(pid_, number);
}

void PseudoTerminal::drain() {
  std::array<char, 4096> bytes{};
  for (ssize_t count = 0; (count = ::read(person_, bytes.data(), bytes.size())) > 0;) {
    output_.append(bytes.data(), static_cast<std::size_t>(count));
  }
}

const std::string& PseudoTerminal::output() {
  drain();
  return output_;
}

std::string PseudoTerminal::letters(std::size_t from) {
  drain();
  std::string letters;
  for (std::size_t at = from; at < output_.size();) {
    if (output_[at] == '\x1b') {
      at = end_of_escape(output_, at);
    } else {
      if (is_graphic(output_[at])) letters += output_[at];
      ++at;
    }
  }
  return letters;
}

bool PseudoTerminal::shows(const std::string& text, std::chrono::milliseconds limit) {
  constexpr std::chrono::milliseconds kPaint{500};
  const std::string wanted = without_blanks(text);
  const auto end = std::chrono::steady_clock::now() + limit;
  do {
    const std::size_t from = output().size();
    type("\f");  // Ctrl-L: every character anew
    if (eventually([&] { return letters(from).find(wanted) != std::string::npos; }, kPaint)) {
      return true;
    }
  } while (!wait(std::chrono::milliseconds(0)) && std::chrono::steady_clock::now() < end);
  return false;
}

std::optional<int> PseudoTerminal::wait(std::chrono::milliseconds limit) {
  eventually(
      [this] {
        drain();
        int status = 0;
        if (!exit_code_ && ::waitpid(pid_, &status, WNOHANG) == pid_) {
          exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        }
        return exit_code_.has_value();
      },
      limit);
  drain();
  return exit_code_;
}

bool PseudoTerminal::is_as_it_was() {
  drain();
  termios now{};
  ::tcgetattr(terminal_, &now);
  const bool same_modes = now.c_iflag == before_.c_iflag && now.c_oflag == before_.c_oflag &&
                          now.c_lflag == before_.c_lflag && now.c_cflag == before_.c_cflag &&
                          std::equal(std::begin(now.c_cc), std::end(now.c_cc), before_.c_cc);
  const auto last = [this](const char* sequence) { return output_.rfind(sequence); };
  const auto before = [](std::size_t a, std::size_t b) {
    return a == std::string::npos || (b != std::string::npos && a < b);
  };
  return same_modes && before(last("\x1b[?1049h"), last("\x1b[?1049l")) &&
         before(last("\x1b[?25l"), last("\x1b[?25h"));
}

}  // namespace scarab::test
