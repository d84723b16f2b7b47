#include <iomanip>
#include <sstream>

#include "common/runtime/words.hpp"
#include "tools/status/report.hpp"

namespace scarab::status {

namespace {

using runtime::word;

std::string counters_of(const runtime::ServiceReport& report) {
  std::string text;
  for (const auto& [counter, value] : report.counters) {
    if (value != 0) text += (text.empty() ? "" : " ") + counter + "=" + std::to_string(value);
  }
  return text;
}

void add_histograms(const runtime::ServiceReport& report, std::ostream& out) {
  for (const auto& [what, histogram] : report.histograms) {
    out << "  " << std::setw(14) << what << "p50 " << histogram.quantile_s(0.5) * 1e3 << " ms, p99 "
        << histogram.quantile_s(0.99) * 1e3 << " ms, max " << histogram.max_s() * 1e3 << " ms, "
        << histogram.total() << " times\n";
  }
}

}  // namespace

std::string table(const Snapshot& snapshot) {
  std::ostringstream out;
  out << std::left << std::setw(16) << "service" << std::setw(13) << "lifecycle" << std::setw(10)
      << "health" << std::setw(7) << "trial" << std::setw(8) << "tick" << std::setw(9) << "ticks/s"
      << std::setw(8) << "pid"
      << "message and counters\n";
  for (const ServiceView& view : snapshot.services) {
    const runtime::ServiceReport& report = view.report;
    std::ostringstream rate;
    rate << std::fixed << std::setprecision(1) << view.rate.ticks_per_s;
    const std::string counters = counters_of(report);
    out << std::setw(16) << bus::to_string(report.peer) << std::setw(13) << word(report.lifecycle)
        << std::setw(10) << word(report.health) << std::setw(7) << report.header.trial
        << std::setw(8) << report.header.tick << std::setw(9) << rate.str() << std::setw(8)
        << report.process_id << report.message
        << (report.message.empty() || counters.empty() ? "" : "; ") << counters << '\n';
    add_histograms(report, out);
  }
  return out.str();
}

}  // namespace scarab::status
