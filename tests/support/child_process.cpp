#include "tests/support/child_process.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>
#include <thread>
#include <utility>

#include "tests/support/files.hpp"

namespace scarab::test {
namespace {

constexpr std::chrono::milliseconds kPoll{1};
constexpr std::chrono::seconds kStopLimit{3};
constexpr int kCannotStart = 127;

std::filesystem::path with_ending(std::filesystem::path path, const char* ending) {
  path += ending;
  return path;
}

/// In the child: only calls that are safe after a fork of a process with threads.
[[noreturn]] void become(char* const* arguments, const char* in, const char* out, const char* err,
                         pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(kCannotStart);  // it died before prctl
  constexpr int kFlags = O_WRONLY | O_CREAT | O_TRUNC;
  constexpr mode_t kMode = 0644;
  const int in_file = ::open(in, O_RDONLY);
  const int out_file = ::open(out, kFlags, kMode);
  const int err_file = ::open(err, kFlags, kMode);
  if (in_file < 0 || out_file < 0 || err_file < 0) ::_exit(kCannotStart);
  ::dup2(in_file, STDIN_FILENO);
  ::dup2(out_file, STDOUT_FILENO);
  ::dup2(err_file, STDERR_FILENO);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::execv(arguments[0], arguments);
  ::_exit(kCannotStart);
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& command,
                           const std::filesystem::path& output, const std::filesystem::path& input)
    : output_(output) {
  if (!std::filesystem::exists(command.front())) {
    throw std::system_error(ENOENT, std::generic_category(), command.front());
  }
  std::vector<std::string> texts = command;
  std::vector<char*> arguments;
  for (auto& text : texts) arguments.push_back(text.data());
  arguments.push_back(nullptr);
  const auto out = with_ending(output_, ".out");
  const auto err = with_ending(output_, ".err");
  const pid_t parent = ::getpid();
  pid_ = ::fork();
  if (pid_ < 0) throw std::system_error(errno, std::generic_category(), command.front());
  if (pid_ == 0) become(arguments.data(), input.c_str(), out.c_str(), err.c_str(), parent);
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)),
      exit_code_(other.exit_code_),
      output_(std::move(other.output_)) {}

ChildProcess::~ChildProcess() {
  if (pid_ > 0 && !stop(kStopLimit)) kill();
}

void ChildProcess::signal(int number) {
  if (running()) ::kill(pid_, number);
}

std::optional<int> ChildProcess::wait(std::chrono::milliseconds limit) {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (!exit_code_) {
    int status = 0;
    if (::waitpid(pid_, &status, WNOHANG) == pid_) {
      exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
      break;
    }
    if (std::chrono::steady_clock::now() >= end) break;
    std::this_thread::sleep_for(kPoll);
  }
  return exit_code_;
}

std::optional<int> ChildProcess::stop(std::chrono::milliseconds limit) {
  signal(SIGTERM);
  return wait(limit);
}

void ChildProcess::kill() {
  signal(SIGKILL);
  wait(std::chrono::seconds(10));
}

std::string ChildProcess::out() const { return read_text(with_ending(output_, ".out")); }

std::string ChildProcess::err() const { return read_text(with_ending(output_, ".err")); }

}  // namespace scarab::test
