#pragma once

namespace scarab::experiment {

/// SIGINT or SIGTERM came; thrown out of what it ends.
struct Interrupted {};

}  // namespace scarab::experiment
