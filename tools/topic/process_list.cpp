#include "tools/topic/process_list.hpp"

#include <algorithm>
#include <tuple>

#include "common/config/json_object.hpp"
#include "tools/topic/text_table.hpp"

namespace scarab::topic {
namespace {

std::string service_of(const ProcessEntry& entry) {
  const bus::Peer& peer = entry.participant.peer;
  return peer.service.empty() ? "" : to_string(peer);
}

std::string or_dash(const std::string& text) { return text.empty() ? "-" : text; }

}  // namespace

std::vector<ProcessEntry> process_list(const DomainView& view) {
  std::vector<ProcessEntry> out;
  for (const auto& [guid, participant] : view.participants) {
    ProcessEntry entry{participant, vendor_of(guid), 0, 0};
    for (const auto& endpoint : view.endpoints) {
      if (endpoint.participant != guid) continue;
      ++(endpoint.kind == bus::EndpointKind::kWriter ? entry.writers : entry.readers);
    }
    out.push_back(std::move(entry));
  }
  std::sort(out.begin(), out.end(), [](const ProcessEntry& a, const ProcessEntry& b) {
    const auto key = [](const ProcessEntry& entry) {
      const auto& participant = entry.participant;
      return std::tuple(participant.host, service_of(entry), participant.process, participant.pid);
    };
    return key(a) < key(b);
  });
  return out;
}

std::string process_table(const std::vector<ProcessEntry>& processes) {
  TextTable table({{"SERVICE"},
                   {"PROGRAM"},
                   {"PID", true},
                   {"HOST"},
                   {"VENDOR"},
                   {"WRITERS", true},
                   {"READERS", true}});
  for (const ProcessEntry& entry : processes) {
    const auto& participant = entry.participant;
    table.add({or_dash(service_of(entry)), or_dash(participant.process),
               participant.pid == 0 ? "-" : std::to_string(participant.pid),
               or_dash(participant.host), entry.vendor, std::to_string(entry.writers),
               std::to_string(entry.readers)});
  }
  return table.text();
}

std::string process_json(const std::vector<ProcessEntry>& processes) {
  std::vector<std::string> rows;
  for (const ProcessEntry& entry : processes) {
    const auto& participant = entry.participant;
    rows.push_back(config::JsonObject()
                       .text("service", service_of(entry))
                       .text("process", participant.process)
                       .number("pid", std::uint64_t{participant.pid})
                       .text("host", participant.host)
                       .text("vendor", entry.vendor)
                       .number("writers", std::uint64_t{entry.writers})
                       .number("readers", std::uint64_t{entry.readers})
                       .str());
  }
  return config::json_list(rows) + "\n";
}

}  // namespace scarab::topic
