#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "common/runtime/status_board.hpp"

namespace scarab::status {

/// How fast a service gets through its trial.
struct Rate {
  double ticks_per_s = 0;       ///< of wall-clock time
  double real_time_factor = 0;  ///< simulated time over wall-clock time
};

/// Rates of all services, from the (tick, simulated time, stamp) that their reports carry: no other
/// topic is read, so that looking on costs the stack nothing.
class RateMeter {
 public:
  /// Takes in what the board shows now; to be called at every change of it.
  void observe(const runtime::StatusBoard& board);
  /// Between the first and the last observation since the last restart(); 0 where nothing moved.
  [[nodiscard]] Rate of(const bus::Peer& peer) const;
  /// Begins the next window.
  void restart();

 private:
  struct Window {
    scarab_Header first{};
    scarab_Header last{};
  };
  std::map<bus::Peer, Window> windows_;
};

}  // namespace scarab::status
