#pragma once

#include <pthread.h>

#include <system_error>

namespace scarab::emulator {

/// A mutex that lends who holds it the priority of who waits for it: a thread of low priority that
/// a busy machine has interrupted inside does not keep one of high priority waiting
/// (pthread_mutexattr_setprotocol(3)).
class LendingMutex {
 public:
  /// Throws std::system_error.
  LendingMutex() {
    pthread_mutexattr_t attributes;
    check(pthread_mutexattr_init(&attributes));
    pthread_mutexattr_setprotocol(&attributes, PTHREAD_PRIO_INHERIT);
    const int error = pthread_mutex_init(&mutex_, &attributes);
    pthread_mutexattr_destroy(&attributes);
    check(error);
  }
  ~LendingMutex() { pthread_mutex_destroy(&mutex_); }
  LendingMutex(const LendingMutex&) = delete;
  LendingMutex& operator=(const LendingMutex&) = delete;

  void lock() { check(pthread_mutex_lock(&mutex_)); }
  void unlock() { pthread_mutex_unlock(&mutex_); }

 private:
  static void check(int error) {
    if (error != 0) throw std::system_error(error, std::generic_category(), "mutex");
  }

  pthread_mutex_t mutex_;
};

}  // namespace scarab::emulator
