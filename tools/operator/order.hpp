#pragma once

#include <string>

#include "common/bus/topics.hpp"
#include "services/supervisor/core/operator_word.hpp"

namespace scarab::operator_desk {

/// What a person wants the stack to do.
struct Order {
  std::string name;  ///< as on the command line
  scarab_OperatorCommand command = scarab_OPERATOR_PAUSE;
  supervisor::OperatorWord word;  ///< for the supervisor's commands
  unsigned times = 1;             ///< for steps
  std::string reason;
};

}  // namespace scarab::operator_desk
