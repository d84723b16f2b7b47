#pragma once

#include <csignal>
#include <ctime>

namespace scarab::fastdds {

/// SIGINT and SIGTERM, kept from all threads. Create it before the first thread.
class StopSignal {
 public:
  StopSignal() {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGINT);
    sigaddset(&signals_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
  }

  /// True from the first of them on.
  bool requested() {
    constexpr timespec kNow{0, 0};
    requested_ = requested_ || sigtimedwait(&signals_, nullptr, &kNow) > 0;
    return requested_;
  }

 private:
  sigset_t signals_{};
  bool requested_ = false;
};

}  // namespace scarab::fastdds
