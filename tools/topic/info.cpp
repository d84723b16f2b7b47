#include <CLI/CLI.hpp>
#include <memory>

#include "common/bus/qos_text.hpp"
#include "common/runtime/program.hpp"
#include "tools/topic/command_options.hpp"
#include "tools/topic/commands.hpp"
#include "tools/topic/quantity.hpp"
#include "tools/topic/session.hpp"
#include "tools/topic/text_table.hpp"
#include "tools/topic/topic_report.hpp"

namespace scarab::topic {
namespace {

constexpr std::chrono::milliseconds kTypePatience{500};

struct InfoOptions {
  std::string topic;
  double timeout_s = 2.0;
  bool json = false;
};

/// `scarab-plant[4711] on alder, Cyclone DDS`.
std::string place_of(const DomainView& view, const bus::DiscoveredEndpoint& endpoint) {
  const bus::DiscoveredParticipant participant = view.participant_of(endpoint);
  std::string out = participant.process;
  if (participant.pid != 0) out += "[" + std::to_string(participant.pid) + "]";
  if (!participant.host.empty()) out += (out.empty() ? "on " : " on ") + participant.host;
  return out + (out.empty() ? "" : ", ") + vendor_of(endpoint.participant);
}

void add_endpoints(const DomainView& view, const TopicReport& report, const char* kind,
                   const std::vector<bus::DiscoveredEndpoint>& endpoints, std::string& out) {
  std::size_t width = 0;
  for (const auto& all : {report.writers, report.readers}) {
    for (const auto& endpoint : all) width = std::max(width, shown_width(view.name_of(endpoint)));
  }
  const std::string margin(std::string(kind).size() + width + 3, ' ');
  for (const auto& endpoint : endpoints) {
    out += std::string(kind) + " " + padded(view.name_of(endpoint), width) + "  " +
           place_of(view, endpoint) + "\n" + margin + bus::qos_text(*endpoint.qos) + "\n";
    if (report.types.size() > 1) out += margin + "type " + endpoint.type + "\n";
  }
}

std::string text_of(const DomainView& view, const TopicReport& report) {
  std::string out = "topic  " + report.topic + "\ntype   " + report.type() + "\n";
  out += counted(report.writers.size(), "writer") + ", " +
         counted(report.readers.size(), "reader") + "\n\n";
  add_endpoints(view, report, "writer", report.writers, out);
  add_endpoints(view, report, "reader", report.readers, out);
  out += "\n";
  const auto faults = fault_notes(view, report);
  for (const std::string& note : type_notes(view, report)) out += "! " + note + "\n";
  for (const std::string& note : faults) out += "! " + note + "\n";
  if (faults.empty() && !report.writers.empty() && !report.readers.empty()) {
    out += "Every reader matches every writer.\n";
  }
  if (report.writers.empty()) out += "! nobody writes it\n";
  return out;
}

int info(const runtime::BusOptions& bus_options, const InfoOptions& options) {
  Session session(bus_options);
  const auto limit = milliseconds(options.timeout_s);
  session.wait_for_endpoints(options.topic, after(limit));
  const DomainView view = session.settle(limit);
  bus::TypeTexts types(session.discovery(), kTypePatience);
  const TopicReport report =
      topic_report(view, options.topic, [&](const auto& endpoint) { return types(endpoint); });
  session.output().write(options.json ? report_json(view, report) + "\n" : text_of(view, report));
  session.output().flush();
  return runtime::kExitSuccess;
}

}  // namespace

void add_info(CLI::App& app, Choice& choice) {
  const auto options = std::make_shared<InfoOptions>();
  CLI::App& command =
      *app.add_subcommand("info", "who writes and reads a topic, how, and who does not match whom");
  add_topic(command, options->topic);
  command.add_flag("--json", options->json, "a line of JSON");
  add_seconds(command, "--timeout", options->timeout_s, "s to wait for the topic");
  command.footer(
      "Tells of each endpoint its service, process, host, DDS vendor and QoS; of endpoints that "
      "do\n"
      "not match the policy that differs: what the writer offers, what the reader asks for.\n"
      "Examples:\n"
      "  scarab-topic info scarab/behaviour\n"
      "  scarab-topic info rt/joint_states --json\n"
      "Exit codes: 0 done, 1 failed, 2 bad usage, 4 no such topic, 130 interrupted.");
  command.callback([&choice, options] {
    choice.run = [&choice, options] { return info(choice.bus, *options); };
  });
}

}  // namespace scarab::topic
