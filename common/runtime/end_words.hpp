#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "common/runtime/tick_body.hpp"

/// How a trial ended, in the message of its tick master's service_status: for those who see no
/// referee's verdict on scarab/world_state.
namespace scarab::runtime {

/// Such as `trial 3 ended: failure: operator stop: lunch`.
[[nodiscard]] std::string end_words(std::uint32_t trial, const TrialEnd& end);

/// The reason in a message that ends with end_words() of that trial.
[[nodiscard]] std::optional<std::string> reason_in(const std::string& message, std::uint32_t trial);

}  // namespace scarab::runtime
