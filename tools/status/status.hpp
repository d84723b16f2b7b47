#pragma once

#include <string>

#include "common/runtime/expectation.hpp"
#include "common/runtime/options.hpp"
#include "common/runtime/status_board.hpp"

namespace scarab::status {

struct StatusOptions {
  runtime::BusOptions bus;
  runtime::Expectation wait_for;  ///< empty: whoever answers within a moment
  double timeout_s = 10;
  bool json = false;
};

/// Prints the services' reports; returns the exit code: 0, or 1 where somebody waited for is
/// missing or faulty, or where nobody is there at all.
int show(const StatusOptions& options);

/// The reports as a table for people, or as one JSON array.
std::string table(const runtime::StatusBoard& board);
std::string json(const runtime::StatusBoard& board);

}  // namespace scarab::status
