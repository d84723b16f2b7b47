#pragma once

#include <set>
#include <string>

#include "common/bus/participant.hpp"

namespace scarab::log {

/// Looks around in the domain, and throws std::runtime_error naming who is there, where somebody
/// writes one of `topics`, or where a tick master reads commands among them. To be asked before the
/// participant has endpoints of its own.
void refuse_company(bus::Participant& participant, const std::set<std::string>& topics);

}  // namespace scarab::log
