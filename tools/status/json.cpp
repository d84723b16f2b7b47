#include "common/config/json.hpp"

#include <sstream>

#include "common/runtime/words.hpp"
#include "tools/status/report.hpp"

namespace scarab::status {
namespace {

using config::in_json_quotes;
using runtime::word;

/// `key`: value pairs in brackets; `text(value)` is JSON already.
template <class Map, class Text>
std::string object(const Map& entries, Text&& text) {
  std::string out;
  for (const auto& [key, value] : entries) {
    out += (out.empty() ? "" : ", ") + in_json_quotes(key) + ": " + text(value);
  }
  return "{" + out + "}";
}

std::string json(const runtime::Histogram& histogram) {
  std::ostringstream out;
  const auto total = histogram.total();
  const double mean_s = total == 0 ? 0.0 : histogram.sum_s() / static_cast<double>(total);
  out << "{\"count\": " << total << ", \"p50_s\": " << histogram.quantile_s(0.5)
      << ", \"p99_s\": " << histogram.quantile_s(0.99) << ", \"max_s\": " << histogram.max_s()
      << ", \"mean_s\": " << mean_s << "}";
  return out.str();
}

std::string json(const ServiceView& view) {
  const runtime::ServiceReport& report = view.report;
  std::ostringstream out;
  out << "{\"service\": " << in_json_quotes(report.peer.service)
      << ", \"instance\": " << report.peer.instance
      << ", \"lifecycle\": " << in_json_quotes(word(report.lifecycle))
      << ", \"health\": " << in_json_quotes(word(report.health))
      << ", \"message\": " << in_json_quotes(report.message)
      << ", \"trial\": " << report.header.trial << ", \"tick\": " << report.header.tick
      << ", \"sim_time_s\": " << static_cast<double>(report.header.sim_time_ns) * 1e-9
      << ", \"stamp_ns\": " << report.header.stamp_ns
      << ", \"ticks_per_s\": " << view.rate.ticks_per_s
      << ", \"real_time_factor\": " << view.rate.real_time_factor
      << ", \"ready_trial\": " << report.ready_trial
      << ", \"recorded_trial\": " << report.recorded_trial
      << ", \"recorded_tick\": " << report.recorded_tick << ", \"pid\": " << report.process_id
      << ", \"host\": " << in_json_quotes(view.host) << ", \"counters\": "
      << object(report.counters, [](std::uint64_t value) { return std::to_string(value); })
      << ", \"histograms\": "
      << object(report.histograms, [](const runtime::Histogram& h) { return json(h); }) << "}";
  return out.str();
}

}  // namespace

std::string json(const Snapshot& snapshot) {
  std::string services;
  for (const ServiceView& view : snapshot.services) {
    services += (services.empty() ? "" : ", ") + json(view);
  }
  return "{\"tick_master\": " + in_json_quotes(snapshot.tick_master) + ", \"services\": [" +
         services + "]}\n";
}

}  // namespace scarab::status
