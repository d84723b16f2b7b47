#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

#include "common/runtime/tick_body.hpp"
#include "common/safety/command_gate.hpp"

namespace scarab::runtime {

/// What a body throws in a trial: a safe stop for a person to reset, or a BodyFailure, where nobody
/// stands by.
enum class OnThrow { kSafeStop, kPassOn };

class BodyFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A body and the gate in front of it, kept in step: what the body tells as a fault, or throws,
/// brings the gate's safe stop, and the body hears of every safe stop at once. Turns its motors off
/// when it goes out of scope. No bus, no clock.
class GuardedBody {
 public:
  /// Both must outlive this.
  GuardedBody(TickBody& body, safety::CommandGate& gate, OnThrow on_throw)
      : body_(body), gate_(gate), on_throw_(on_throw) {}
  ~GuardedBody() { rest(); }
  GuardedBody(const GuardedBody&) = delete;
  GuardedBody& operator=(const GuardedBody&) = delete;

  /// Begins the gate's trial, with the motors on where the joints stand; in a safe stop they stay
  /// off. Throws std::exception saying why that cannot be; then they are off.
  void begin_trial(std::uint32_t trial);
  /// The trial is over, for the gate as well as for the motors.
  void end_trial() noexcept;
  /// Motors off; what follows of the trial is without them.
  void rest() noexcept;

  /// CommandGate::expect().
  void expect(std::uint32_t tick);
  void emergency_stop(const std::string& reason);
  /// Ends the trial from outside, and stops the body at once.
  void end(const TrialEnd& end);
  /// Leaves the safe stop, in a trial with the motors on again. Not while a fault lasts: then, and
  /// where the motors do not come on, it says why not, and the safe stop stays.
  std::optional<std::string> reset();

  /// TickBody::observe(); a blank state where it throws. False then. Throws BodyFailure.
  bool observe(scarab_RobotState& state);
  /// TickBody::advance(). Throws BodyFailure.
  void advance(const robot::JointVector& target_rad, const std::function<void()>& sample);
  /// TickBody::idle(); false where it throws.
  bool idle();

  /// What forbids to go on.
  [[nodiscard]] std::optional<std::string> fault() const;
  /// In a trial with the motors on, and without a fault since its begin or the last reset.
  [[nodiscard]] bool active() const noexcept { return active_ && body_.powered(); }

 private:
  void take_thrown(const std::exception& error);
  void watch_for_fault();
  void follow_gate() noexcept;

  TickBody& body_;
  safety::CommandGate& gate_;
  OnThrow on_throw_;
  std::optional<std::string> thrown_;  // since the last observe() or idle() that did not
  bool in_trial_ = false;              // motors may be on
  bool active_ = false;
  bool stop_told_ = false;  // the body knows of the gate's safe stop
};

}  // namespace scarab::runtime
