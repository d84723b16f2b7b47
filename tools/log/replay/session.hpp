#pragma once

#include <chrono>

#include "common/bus/participant.hpp"
#include "common/bus/waitset.hpp"
#include "common/runtime/options.hpp"
#include "common/runtime/shutdown.hpp"

namespace scarab::log {

/// Until the user interrupts: thrown by waits of a Session, caught where the replay ends.
struct Interrupted {};

/// A participant that waits, for samples or for a time, until Ctrl-C. Needs a runtime::SignalBlock
/// made before.
class Session {
 public:
  using Clock = std::chrono::steady_clock;

  explicit Session(const bus::ParticipantOptions& options)
      : participant_(options), guard_(participant_), shutdown_(guard_), wait_set_(participant_) {
    wait_set_.attach(guard_);
  }

  bus::Participant& participant() { return participant_; }
  /// What it waits for beside time.
  bus::WaitSet& wait_set() { return wait_set_; }

  /// Waits for samples, at most so long. Throws Interrupted.
  void wait(std::chrono::nanoseconds most) {
    wait_set_.wait(most);
    if (shutdown_.requested()) throw Interrupted{};
  }
  /// Waits for a time, whatever comes. Throws Interrupted. What waits to be taken is not waited for
  /// again: not for sessions with readers.
  void sleep_until(Clock::time_point time) {
    for (auto left = time - Clock::now(); left.count() > 0; left = time - Clock::now()) wait(left);
    if (shutdown_.requested()) throw Interrupted{};
  }
  bool interrupted() const { return shutdown_.requested(); }

 private:
  bus::Participant participant_;
  bus::Guard guard_;
  runtime::Shutdown shutdown_;
  bus::WaitSet wait_set_;
};

}  // namespace scarab::log
