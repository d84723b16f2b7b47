#include <iomanip>
#include <sstream>

#include "tools/status/status.hpp"

namespace scarab::status {
namespace {

const char* name(scarab_Lifecycle lifecycle) {
  switch (lifecycle) {
    case scarab_LIFECYCLE_UNCONFIGURED:
      return "unconfigured";
    case scarab_LIFECYCLE_INACTIVE:
      return "inactive";
    case scarab_LIFECYCLE_ACTIVE:
      return "active";
    case scarab_LIFECYCLE_FINALISED:
      return "finalised";
  }
  return "unknown";
}

const char* name(scarab_Health health) {
  switch (health) {
    case scarab_HEALTH_OK:
      return "ok";
    case scarab_HEALTH_WAITING:
      return "waiting";
    case scarab_HEALTH_DEGRADED:
      return "degraded";
    case scarab_HEALTH_FAULT:
      return "fault";
  }
  return "unknown";
}

std::string quoted(const std::string& text) {
  std::ostringstream out;
  out << '"';
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out << '\\' << c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      out << "\\u" << std::hex << std::setw(4) << std::setfill('0') << static_cast<int>(c)
          << std::dec;
    } else {
      out << c;
    }
  }
  out << '"';
  return out.str();
}

std::string counters_of(const runtime::ServiceReport& report) {
  std::string text;
  for (const auto& [counter, value] : report.counters) {
    if (value != 0) text += (text.empty() ? "" : " ") + counter + "=" + std::to_string(value);
  }
  return text;
}

std::string json(const runtime::ServiceReport& report) {
  std::ostringstream out;
  out << "{\"service\": " << quoted(report.peer.service)
      << ", \"instance\": " << report.peer.instance
      << ", \"lifecycle\": " << quoted(name(report.lifecycle))
      << ", \"health\": " << quoted(name(report.health))
      << ", \"message\": " << quoted(report.message) << ", \"trial\": " << report.header.trial
      << ", \"tick\": " << report.header.tick << ", \"ready_trial\": " << report.ready_trial
      << ", \"recorded_trial\": " << report.recorded_trial
      << ", \"recorded_tick\": " << report.recorded_tick << ", \"pid\": " << report.process_id
      << ", \"counters\": {";
  const char* separator = "";
  for (const auto& [counter, value] : report.counters) {
    out << separator << quoted(counter) << ": " << value;
    separator = ", ";
  }
  out << "}}";
  return out.str();
}

}  // namespace

std::string table(const runtime::StatusBoard& board) {
  std::ostringstream out;
  out << std::left << std::setw(16) << "service" << std::setw(13) << "lifecycle" << std::setw(10)
      << "health" << std::setw(7) << "trial" << std::setw(8) << "tick" << std::setw(8) << "pid"
      << "message and counters\n";
  for (const auto& [peer, report] : board.reports()) {
    const std::string counters = counters_of(report);
    out << std::setw(16) << bus::to_string(peer) << std::setw(13) << name(report.lifecycle)
        << std::setw(10) << name(report.health) << std::setw(7) << report.header.trial
        << std::setw(8) << report.header.tick << std::setw(8) << report.process_id << report.message
        << (report.message.empty() || counters.empty() ? "" : "; ") << counters << '\n';
  }
  return out.str();
}

std::string json(const runtime::StatusBoard& board) {
  std::string text = "[";
  for (const auto& [peer, report] : board.reports()) {
    text += (text.size() > 1 ? ",\n " : "") + json(report);
  }
  return text + "]\n";
}

}  // namespace scarab::status
