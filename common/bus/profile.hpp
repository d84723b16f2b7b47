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

}  // namespace scarab::bus
