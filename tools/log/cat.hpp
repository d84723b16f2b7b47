#pragma once

#include <cstdint>
#include <optional>
#include <ostream>

#include "tools/log/selection.hpp"

namespace scarab::log {

struct CatOptions {
  bool json = false;                  ///< one line a message; else YAML documents
  std::optional<std::uint64_t> most;  ///< messages to print at most
};

/// Prints the messages of a selection in the order of the log. A message of a channel without type
/// is shown as bytes, in hexadecimal. Returns how many were printed.
///
/// As JSON a message is `{"topic":"..","sequence":3,"log_time_ns":"..","publish_time_ns":"..",
/// "value":{..}}`; with fields, `value` has a key for each of them; bytes stand in `bytes`. Throws
/// mcap::Error, and bus::Error for a message that is no sample of its type.
std::uint64_t print_messages(const Log& log, const Selection& selection, const CatOptions& options,
                             std::ostream& out);

}  // namespace scarab::log
