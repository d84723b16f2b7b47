#pragma once

#include "tools/operator/order.hpp"

namespace CLI {
class App;
}

namespace scarab::operator_desk {

/// Adds a subcommand for each command of scarab/operator; the one that is called fills `order`.
void add_commands(CLI::App& app, Order& order);

/// Throws CLI::RequiredError if the command line had no command.
void check_given(const Order& order);

}  // namespace scarab::operator_desk
