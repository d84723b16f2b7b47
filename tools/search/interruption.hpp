#pragma once

#include <atomic>

namespace scarab::search {

/// From now on SIGINT and SIGTERM set the flag that is returned, which lives as long as the
/// program: a signal handler reaches nothing else.
[[nodiscard]] const std::atomic<bool>& watch_for_interruption();

}  // namespace scarab::search
