#pragma once

#include <cstdint>
#include <optional>

#include "common/mcap/records.hpp"

namespace scarab::logger {

/// What the log says of a trial apart from its samples.
struct TrialNote {
  std::uint32_t number = 0;  ///< 0: there has been none
  mcap::Metadata metadata;   ///< `scarab.trial`: number, seed, strategy, goal, scene, time
};

/// From a sample of scarab/trial; nothing when the bytes are none.
std::optional<TrialNote> read_trial_note(mcap::ByteView cdr);

}  // namespace scarab::logger
