#include "tools/topic/topic_table.hpp"

#include <algorithm>

#include "common/bus/qos_text.hpp"
#include "tools/topic/text_table.hpp"

namespace scarab::topic {
namespace {

constexpr std::size_t kMostNotes = 3;

void add_endpoints(TextTable& table, const DomainView& view, const TopicReport& report) {
  const auto add = [&](const char* kind, const std::vector<bus::DiscoveredEndpoint>& endpoints) {
    for (const auto& endpoint : endpoints) {
      table.add_note(std::string("    ") + kind + " " + padded(view.name_of(endpoint), 16) + " " +
                     bus::qos_text(*endpoint.qos));
    }
  };
  add("writer", report.writers);
  add("reader", report.readers);
}

void add_notes(TextTable& table, const DomainView& view, const TopicReport& report) {
  auto notes = type_notes(view, report);
  const auto faults = fault_notes(view, report);
  notes.insert(notes.end(), faults.begin(), faults.end());
  for (std::size_t i = 0; i < std::min(notes.size(), kMostNotes); ++i) {
    table.add_note("  ! " + notes[i]);
  }
  if (notes.size() > kMostNotes) {
    table.add_note("  ! and " + std::to_string(notes.size() - kMostNotes) +
                   " more: scarab-topic info " + report.topic);
  }
}

TextTable table_of(const DomainView& view, const std::vector<TopicReport>& reports,
                   std::size_t most_names, bool verbose) {
  TextTable table({{"TOPIC"}, {"TYPE"}, {"WRITERS"}, {"READERS"}});
  for (const TopicReport& report : reports) {
    table.add({report.topic, report.type(), names_of(view, report.writers, most_names),
               names_of(view, report.readers, most_names)});
    if (verbose) add_endpoints(table, view, report);
    add_notes(table, view, report);
  }
  return table;
}

}  // namespace

std::string topic_table(const DomainView& view, const std::vector<TopicReport>& reports,
                        std::size_t width, bool verbose) {
  const TextTable full = table_of(view, reports, 0, verbose);
  if (width == 0 || full.width() <= width) return full.text();
  return table_of(view, reports, 1, verbose).text();
}

}  // namespace scarab::topic
