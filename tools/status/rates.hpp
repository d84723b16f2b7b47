#pragma once

#include <chrono>
#include <deque>
#include <map>

#include "common/runtime/status_board.hpp"

namespace scarab::status {

/// How fast a service gets through its trial.
struct Rate {
  double ticks_per_s = 0;       ///< of wall-clock time
  double real_time_factor = 0;  ///< simulated time over wall-clock time
};

/// Rates of all services, from the (tick, simulated time, stamp) that their reports carry: no other
/// topic is read, so that looking on costs the stack nothing. A report is up to one tick older than
/// its stamp, so that the rate over kWindow is right to a tick in that time.
class RateMeter {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  static constexpr std::chrono::seconds kWindow{5};
  /// A service that goes on reports more often than this.
  static constexpr std::chrono::seconds kStandstill{1};

  /// Takes in what the board shows now; to be called at every change of it.
  void observe(const std::map<bus::Peer, runtime::ServiceReport>& reports, TimePoint now);
  /// Over the last kWindow of its trial; 0 for who has stood still for kStandstill.
  [[nodiscard]] Rate of(const bus::Peer& peer, TimePoint now) const;

 private:
  struct Track {
    std::deque<scarab_Header> headers;  // of one trial, oldest first
    TimePoint moved{};
  };
  std::map<bus::Peer, Track> tracks_;
};

}  // namespace scarab::status
