#pragma once

namespace scarab::bus {

/// QoS profiles, named by data-flow pattern.
enum class Profile {
  kStream,   ///< reliable, volatile, keep-last 64
  kCommand,  ///< reliable, volatile, keep-last 64
  kState,    ///< reliable, transient-local, keep-last 64, one kept for late joiners
  kStatus,   ///< reliable, transient-local, keep-last 1 a key, automatic liveliness with a lease of
             ///< 1 s
};

/// The profile's name in the documentation.
constexpr const char* profile_name(Profile profile) {
  switch (profile) {
    case Profile::kStream:
      return "stream";
    case Profile::kCommand:
      return "command";
    case Profile::kState:
      return "state";
    case Profile::kStatus:
      return "status";
  }
  return "unknown";
}

}  // namespace scarab::bus
