#include "tools/log/replay/topic_writer.hpp"

#include "common/bus/error.hpp"
#include "common/bus/known_types.hpp"
#include "common/bus/stored_type.hpp"
#include "tools/log/replay/base64.hpp"

namespace scarab::log {
namespace {

using Words = std::map<std::string, std::string>;

constexpr std::string_view kQosPrefix = "qos.";

Words qos_words(const LogChannel& channel) {
  Words words;
  for (const auto& [key, value] : channel.record.metadata) {
    if (key.compare(0, kQosPrefix.size(), kQosPrefix) == 0) {
      words[key.substr(kQosPrefix.size())] = value;
    }
  }
  return words;
}

bus::TopicType type_of(bus::Participant& participant, const LogChannel& channel) {
  const Words& metadata = channel.record.metadata;
  const auto information = metadata.find("type_information");
  const auto mapping = metadata.find("type_mapping");
  const auto type = metadata.find("type");
  const std::string& name = type == metadata.end() ? channel.type_name : type->second;
  if (information != metadata.end() && mapping != metadata.end()) {
    return bus::restore_type(
        participant, {name, base64_bytes(information->second), base64_bytes(mapping->second)});
  }
  const auto* known = bus::find_known_type(name);
  if (known == nullptr) {
    throw bus::Error(channel.topic + ": the log does not hold the DDS type to publish it with");
  }
  return bus::borrow_compiled(*known);
}

/// So that a write waits for readers that are behind, and overwrites nothing they have not got yet.
bus::RawQos patient(bus::RawQos qos) {
  qos.late_joiner_depth = 1;  // as the project's writers
  qos.history_depth = 0;
  return qos;
}

}  // namespace

bus::RawQos recorded_qos(const LogChannel& channel) {
  const Words words = qos_words(channel);
  if (!words.empty()) return bus::raw_qos_from_words(words);
  bus::RawQos qos;
  if (channel.topic.rfind("scarab/", 0) == 0) qos.durability = DDS_DURABILITY_TRANSIENT_LOCAL;
  if (channel.topic == "scarab/service_status") qos.liveliness_lease = std::chrono::seconds(1);
  return qos;
}

TopicWriter::TopicWriter(bus::Participant& participant, const LogChannel& channel)
    : writer_(participant, channel.topic, type_of(participant, channel),
              patient(recorded_qos(channel))) {}

void TopicWriter::write(const mcap::Bytes& cdr, std::optional<std::int64_t> source_ns) {
  const sample::ByteView bytes{reinterpret_cast<const std::byte*>(cdr.data()), cdr.size()};
  if (source_ns) {
    writer_.write(bytes, *source_ns);
  } else {
    writer_.write(bytes);
  }
}

}  // namespace scarab::log
