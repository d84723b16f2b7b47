#pragma once

#include <atomic>
#include <thread>

#include "common/bus/waitset.hpp"

namespace scarab::runtime {

/// Keeps SIGINT and SIGTERM from every thread started after it. Make one first thing in main,
/// before any participant.
class SignalBlock {
 public:
  SignalBlock();
};

/// Turns SIGINT and SIGTERM into a flag and a wake-up of the wait set that `guard` is attached to.
/// Needs a SignalBlock made before; the guard must outlive this.
class Shutdown {
 public:
  explicit Shutdown(bus::Guard& guard);
  ~Shutdown();
  Shutdown(const Shutdown&) = delete;
  Shutdown& operator=(const Shutdown&) = delete;

  [[nodiscard]] bool requested() const noexcept { return requested_.load(); }

 private:
  void wait_for_signal();

  bus::Guard& guard_;
  std::atomic<bool> requested_{false};
  std::atomic<bool> finished_{false};
  std::thread thread_;
};

}  // namespace scarab::runtime
