#pragma once

#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <mutex>
#include <system_error>
#include <utility>

#include "tools/emulator/lending_mutex.hpp"

namespace scarab::emulator {

/// What one thread leaves for another. `Letter` collects what is added to it until it is taken as a
/// whole. Neither side ever waits for what the other does with it.
template <class Letter>
class Mailbox {
 public:
  /// Throws std::system_error.
  Mailbox() : fd_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
    if (fd_ < 0) throw std::system_error(errno, std::generic_category(), "eventfd");
  }
  ~Mailbox() { ::close(fd_); }
  Mailbox(const Mailbox&) = delete;
  Mailbox& operator=(const Mailbox&) = delete;

  /// `add(Letter&)` is called with what has not been taken yet; it should be short.
  template <class Add>
  void put(Add&& add) {
    {
      const std::lock_guard<LendingMutex> lock(mutex_);
      add(letter_);
    }
    (void)::eventfd_write(fd_, 1);
  }
  /// All that has been put since the last time.
  [[nodiscard]] Letter take() {
    eventfd_t count = 0;
    (void)::eventfd_read(fd_, &count);
    const std::lock_guard<LendingMutex> lock(mutex_);
    return std::exchange(letter_, Letter{});
  }
  /// What ppoll() waits on: readable once something has been put.
  [[nodiscard]] int fd() const { return fd_; }

 private:
  int fd_;
  LendingMutex mutex_;
  Letter letter_;
};

}  // namespace scarab::emulator
