#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace scarab::safety {

/// What the command gate says of an offered command.
enum class Verdict {
  kAccepted,    ///< the answer that was wanted
  kDuplicate,   ///< the accepted answer again, from a replica or a restarted service: fine
  kInactive,    ///< refused: no trial runs
  kNotFinite,   ///< refused: a target is NaN or infinite
  kWrongTrial,  ///< refused: of another trial
  kStaleTick,   ///< refused: answers a tick that is over, or too late
  kFutureTick,  ///< refused: answers a tick that has not been asked
  kConflict,    ///< refused: a second, different answer to one tick; a fault of who wrote it
  kSafeStop,    ///< refused: the safe stop holds until it is reset
};

inline constexpr std::size_t kVerdictCount = 9;

/// As counted and shown in service_status, in the order of Verdict.
inline constexpr std::array<std::string_view, kVerdictCount> kVerdictNames = {
    "accepted",           "duplicate",           "refused_inactive",
    "refused_not_finite", "refused_wrong_trial", "refused_stale",
    "refused_future",     "refused_conflict",    "refused_safe_stop"};

constexpr std::string_view name(Verdict verdict) {
  return kVerdictNames[static_cast<std::size_t>(verdict)];
}

/// The command stands (new or again); otherwise it was refused.
constexpr bool stands(Verdict verdict) {
  return verdict == Verdict::kAccepted || verdict == Verdict::kDuplicate;
}

}  // namespace scarab::safety
