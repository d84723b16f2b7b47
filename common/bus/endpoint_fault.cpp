#include "common/bus/endpoint_fault.hpp"

#include <set>
#include <sstream>
#include <utility>

#include "common/bus/compatibility.hpp"
#include "common/bus/topic_type.hpp"
#include "common/sample/idl_text.hpp"

namespace scarab::bus {

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// `one with "double speed"`: the first member of `text` that `other` does not have.
std::string own_member(const std::string& text, const std::string& other) {
  const auto others = lines_of(other);
  const std::set<std::string> known(others.begin(), others.end());
  for (const std::string& line : lines_of(text)) {
    const std::size_t start = line.find_first_not_of(' ');
    const std::size_t end = line.find(';');
    if (start == std::string::npos || end == std::string::npos || line[start] == '}') continue;
    if (known.count(line) == 0) return "one with \"" + line.substr(start, end - start) + '"';
  }
  return "one without that";
}

/// Two programs of different versions: the same name, not the same fields.
void compare_types(const DiscoveredEndpoint& writer, const DiscoveredEndpoint& reader,
                   const TypeText& type_text, std::vector<EndpointFault>& out) {
  if (writer.type != reader.type) {
    out.push_back({writer, reader, "type name", writer.type, reader.type});
    return;
  }
  const std::string written = type_text(writer);
  const std::string read = type_text(reader);
  if (written.empty() || read.empty() || written == read) return;
  out.push_back({writer, reader, "type", own_member(written, read), own_member(read, written)});
}

}  // namespace

std::vector<EndpointFault> endpoint_faults(const std::vector<DiscoveredEndpoint>& endpoints,
                                           const TypeText& type_text) {
  std::vector<EndpointFault> out;
  for (const DiscoveredEndpoint& writer : endpoints) {
    if (writer.kind != EndpointKind::kWriter) continue;
    for (const DiscoveredEndpoint& reader : endpoints) {
      if (reader.kind != EndpointKind::kReader || reader.topic != writer.topic) continue;
      compare_types(writer, reader, type_text, out);
      for (Mismatch& found : mismatches(*writer.qos, *reader.qos)) {
        out.push_back({writer, reader, std::move(found.policy), std::move(found.offered),
                       std::move(found.asked)});
      }
    }
  }
  return out;
}

std::string TypeTexts::operator()(const DiscoveredEndpoint& endpoint) {
  const auto [entry, fresh] = texts_.try_emplace(endpoint.guid);
  if (fresh) {
    try {
      const TopicType type = discovery_.type_of(endpoint, patience_);
      entry->second = sample::idl_text(model_of(*type));
    } catch (const Error&) {
      // It does not tell its type; its name is all there is to compare.
    }
  }
  return entry->second;
}

}  // namespace scarab::bus
