#include "tools/status/rates.hpp"

namespace scarab::status {
namespace {

bool is_older_than_window(const scarab_Header& header, const scarab_Header& newest) {
  return newest.stamp_ns - header.stamp_ns > std::chrono::nanoseconds(RateMeter::kWindow).count();
}

}  // namespace

void RateMeter::observe(const std::map<bus::Peer, runtime::ServiceReport>& reports, TimePoint now) {
  for (const auto& [peer, report] : reports) {
    auto& [headers, moved] = tracks_[peer];
    const scarab_Header& header = report.header;
    if (!headers.empty()) {
      const scarab_Header& last = headers.back();
      if (header.trial == last.trial && header.tick == last.tick) continue;
      // A new trial, or a service that has started anew, counts from its beginning.
      if (header.trial != last.trial || header.tick < last.tick) headers.clear();
    }
    headers.push_back(header);
    moved = now;
    while (headers.size() > 2 && is_older_than_window(headers.front(), header)) headers.pop_front();
  }
}

Rate RateMeter::of(const bus::Peer& peer, TimePoint now) const {
  const auto found = tracks_.find(peer);
  if (found == tracks_.end() || now - found->second.moved > kStandstill) return {};
  const scarab_Header& first = found->second.headers.front();
  const scarab_Header& last = found->second.headers.back();
  const auto wall_ns = static_cast<double>(last.stamp_ns - first.stamp_ns);
  if (wall_ns <= 0) return {};
  return {static_cast<double>(last.tick - first.tick) / (wall_ns * 1e-9),
          static_cast<double>(last.sim_time_ns - first.sim_time_ns) / wall_ns};
}

}  // namespace scarab::status
