#pragma once

#include "common/runtime/options.hpp"
#include "tools/operator/order.hpp"

namespace scarab::operator_desk {

/// Gives the order on scarab/operator, waits until who is to carry it out acknowledges it, and
/// prints what holds then. Returns the exit code: kExitFailure, with a sentence, if nobody listens,
/// nobody acknowledges, or the order is refused.
int give(const runtime::BusOptions& bus_options, const Order& order);

}  // namespace scarab::operator_desk
