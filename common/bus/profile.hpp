#pragma once

namespace scarab::bus {

/// How many samples a writer keeps for a reader that lags behind, and a reader for who takes them.
inline constexpr unsigned kDepth = 64;
/// The same of a stream's writer: kDepth ticks of up to eight samples each.
inline constexpr unsigned kStreamDepth = 8 * kDepth;

/// QoS profiles, named by data-flow pattern. Every writer offers transient-local with one sample
/// for late joiners: a volatile reader drops what arrives between its match and the writer's first
/// heartbeat, so that a first sample could be lost though both sides are matched. Who needs every
/// sample (command, state, the logger) asks for transient-local; views of a stream do not.
enum class Profile {
  kStream,   ///< reliable, readers volatile, keep-last 64; writers keep-last kStreamDepth
  kCommand,  ///< reliable, transient-local, keep-last 64; a reader judges by itself what is stale
  kState,    ///< reliable, transient-local, keep-last 64; late joiners count on the last sample
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
