#pragma once

#include <string>
#include <vector>

#include "common/runtime/status_board.hpp"
#include "tools/status/rates.hpp"

namespace scarab::status {

/// One service as it is shown.
struct ServiceView {
  runtime::ServiceReport report;
  std::string host;  ///< empty where its participant does not tell
  Rate rate;
};

/// What there is to show.
struct Snapshot {
  std::string tick_master;  ///< who writes scarab/robot_state, such as plant/0; empty: nobody
  std::vector<ServiceView> services;
};

/// For people: a line a service, below it what was refused or clamped, and its histograms.
std::string table(const Snapshot& snapshot);
/// One JSON document, on one line; README.md lists the keys.
std::string json(const Snapshot& snapshot);

}  // namespace scarab::status
