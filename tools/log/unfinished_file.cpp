#include "tools/log/unfinished_file.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <system_error>
#include <utility>

#include "common/runtime/program.hpp"

namespace scarab::log {
namespace {

/// What a signal handler can reach: nothing but a global.
std::atomic<const char*> unfinished{nullptr};

extern "C" void remove_and_end(int /*signal*/) {
  if (const char* path = unfinished.load()) ::unlink(path);
  ::_exit(runtime::kExitInterrupted);
}

/// Signals that are ignored stay so: those of a job in the background.
void set_handlers(void (*handler)(int)) {
  for (const int signal : {SIGINT, SIGTERM}) {
    if (std::signal(signal, handler) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
}

}  // namespace

UnfinishedFile::UnfinishedFile(std::filesystem::path path) : path_(std::move(path)) {
  unfinished = path_.c_str();
  set_handlers(remove_and_end);
}

UnfinishedFile::~UnfinishedFile() {
  set_handlers(SIG_DFL);
  unfinished = nullptr;
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

}  // namespace scarab::log
