#pragma once

#include "common/runtime/expectation.hpp"
#include "common/runtime/options.hpp"

namespace scarab::status {

struct StatusOptions {
  runtime::BusOptions bus;
  runtime::Expectation wait_for;  ///< empty: whoever answers while it looks
  double timeout_s = 10;          ///< of the wait
  bool progress = false;          ///< says on stderr what a long wait is for
  double look_s = 0;              ///< at least; for rates
  bool json = false;
  bool watch = false;  ///< again and again, until SIGINT or SIGTERM
  double period_s = 1;
};

/// Prints the services' reports; returns the exit code: 0, or 1 where somebody waited for is
/// missing or faulty, or where nobody is there at all. A fault ends the wait once all are there: it
/// does not pass by waiting.
int show(const StatusOptions& options);

/// Prints them every period until it is asked to stop; returns 0.
int watch(const StatusOptions& options);

}  // namespace scarab::status
