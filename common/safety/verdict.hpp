#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace scarab::safety {

/// What became of a command that was offered to the gate.
enum class Outcome {
  kAccepted,    ///< the answer that was wanted
  kDuplicate,   ///< an answer already known, again, from a replica or a restarted service: fine
  kInactive,    ///< refused: no trial runs
  kNotFinite,   ///< refused: a target is NaN or infinite; a fault of who wrote it
  kWrongTrial,  ///< refused: of another trial
  kStaleTick,   ///< refused: answers a tick that is over
  kFutureTick,  ///< refused: answers a tick that has not been asked
  kConflict,    ///< refused: a second, different answer to one tick; a fault of who wrote it
  kSafeStop,    ///< the wanted answer, but not applied: the safe stop holds until it is reset
  kHoming,      ///< the wanted answer, but not applied: the robot is on its way to the start pose
};

inline constexpr std::size_t kOutcomeCount = 10;

/// As counted and shown in service_status, in the order of Outcome.
inline constexpr std::array<std::string_view, kOutcomeCount> kOutcomeNames = {
    "commands_accepted",       "commands_duplicate",        "commands_refused_inactive",
    "commands_refused_finite", "commands_refused_trial",    "commands_refused_stale",
    "commands_refused_future", "commands_refused_conflict", "commands_refused_safe_stop",
    "commands_refused_homing"};

/// The gate's answer to one offer.
struct Verdict {
  Outcome outcome = Outcome::kInactive;
  bool answers = false;  ///< the expected tick now has its answer: the tick master may go on
  std::string fault;     ///< not empty: what is wrong with the writer of this command
};

}  // namespace scarab::safety
