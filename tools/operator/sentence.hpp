#pragma once

#include <string>

#include "common/runtime/status_board.hpp"
#include "tools/operator/order.hpp"

namespace scarab::operator_desk {

/// What a service says of itself, for a person: "plant/0: paused by the operator (trial 1, tick
/// 42)".
std::string sentence(const runtime::ServiceReport& report);

/// The tick master holds the trial before its next tick, for the operator.
bool is_paused(const runtime::ServiceReport& report);

/// `now` shows what the order brings about. `before` is of the moment it was given.
bool shows_effect(const Order& order, const runtime::ServiceReport& before,
                  const runtime::ServiceReport& now);

}  // namespace scarab::operator_desk
