#include "common/runtime/shutdown.hpp"

#include <csignal>
#include <ctime>

namespace scarab::runtime {
namespace {

sigset_t stop_signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

}  // namespace

SignalBlock::SignalBlock() {
  const sigset_t set = stop_signals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
}

Shutdown::Shutdown(bus::Guard& guard) : guard_(guard), thread_([this] { wait_for_signal(); }) {}

Shutdown::~Shutdown() {
  finished_ = true;
  thread_.join();
}

void Shutdown::wait_for_signal() {
  const sigset_t set = stop_signals();
  // Looks up now and then only to end with its owner; a signal wakes it at once.
  const timespec patience{0, 100'000'000};
  while (!finished_) {
    if (sigtimedwait(&set, nullptr, &patience) > 0) {
      requested_ = true;
      guard_.trigger();
    }
  }
}

}  // namespace scarab::runtime
