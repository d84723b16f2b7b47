#pragma once

#include <string>

#include "common/sample/error.hpp"

namespace scarab::bus {

/// A failure of the bus. what() names the entity, its topic and the cause, such as
/// `reader on scarab/behaviour: inconsistent type` or `interface eth7 not found`.
using Error = sample::Error;

/// Returns `code` when it is no error; otherwise throws Error with `context: cause`, where the
/// cause is Cyclone's name of the code.
int check(int code, const std::string& context);

}  // namespace scarab::bus
