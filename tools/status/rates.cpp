#include "tools/status/rates.hpp"

namespace scarab::status {

void RateMeter::observe(const runtime::StatusBoard& board) {
  for (const auto& [peer, report] : board.reports()) {
    const auto [entry, fresh] = windows_.try_emplace(peer, Window{report.header, report.header});
    Window& window = entry->second;
    // A new trial, or a service that has started anew, counts from its beginning.
    const bool backwards = report.header.tick < window.last.tick;
    if (fresh || report.header.trial != window.last.trial || backwards) {
      window.first = report.header;
    }
    window.last = report.header;
  }
}

Rate RateMeter::of(const bus::Peer& peer) const {
  const auto found = windows_.find(peer);
  if (found == windows_.end()) return {};
  const auto& [first, last] = found->second;
  const double wall_ns = static_cast<double>(last.stamp_ns - first.stamp_ns);
  if (wall_ns <= 0) return {};
  return {static_cast<double>(last.tick - first.tick) / (wall_ns * 1e-9),
          static_cast<double>(last.sim_time_ns - first.sim_time_ns) / wall_ns};
}

void RateMeter::restart() {
  for (auto& [peer, window] : windows_) window.first = window.last;
}

}  // namespace scarab::status
