#include "common/runtime/shutdown.hpp"

#include <csignal>

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
  pthread_kill(thread_.native_handle(), SIGTERM);  // for the thread alone, which waits for one
  thread_.join();
}

void Shutdown::wait_for_signal() {
  const sigset_t set = stop_signals();
  while (!finished_) {
    int signal = 0;
    if (sigwait(&set, &signal) == 0 && !finished_) {
      requested_ = true;
      guard_.trigger();
    }
  }
}

}  // namespace scarab::runtime
