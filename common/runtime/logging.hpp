#pragma once

#include <string>

namespace scarab::runtime {

/// Makes the default logger write to stderr, one line an event, with time, level and
/// `<service>/<instance>`.
void set_up_logging(const std::string& service, unsigned instance, const std::string& level);

}  // namespace scarab::runtime
