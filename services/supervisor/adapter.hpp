#pragma once

#include <optional>

#include "common/bus/topics.hpp"
#include "services/supervisor/core/behaviour_machine.hpp"

/// IDL types <-> core types of the supervisor. No I/O; headers are the caller's.
namespace scarab::supervisor {

Perception to_perception(const scarab_RobotState& state);

/// Nothing: the command is for the tick master.
std::optional<OperatorWord> to_word(const scarab_Operator& said);

/// Fills all but the header; throws bus::Error for a strategy's name that is too long, cuts a
/// reason.
void fill(scarab_Operator& said, const OperatorWord& word);

/// Fills all but the header.
void fill(scarab_Behaviour& behaviour, const Decision& decision);

}  // namespace scarab::supervisor
