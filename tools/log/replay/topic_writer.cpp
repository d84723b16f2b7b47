#include "tools/log/replay/topic_writer.hpp"

#include <algorithm>

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
    : qos_(recorded_qos(channel)),
      writer_(participant, channel.topic, type_of(participant, channel), qos_) {}

void TopicWriter::write(const mcap::Bytes& cdr, std::optional<std::int64_t> source_ns) {
  constexpr std::chrono::seconds kPatience{1};
  // Half of what the writer keeps may be on its way; beyond all of it samples would be lost.
  const int most = std::max(1, qos_.history_depth / 2);
  if (qos_.history_depth > 0 && unacknowledged_ >= most) {
    if (!writer_.await_acknowledged(kPatience)) {
      std::string readers;
      for (const auto& peer : writer_.matched()) readers += " " + bus::to_string(peer);
      throw bus::Error(topic() + ": readers do not acknowledge:" + readers);
    }
    unacknowledged_ = 0;
  }
  const bus::ByteView bytes{reinterpret_cast<const std::byte*>(cdr.data()), cdr.size()};
  if (source_ns) {
    writer_.write(bytes, *source_ns);
  } else {
    writer_.write(bytes);
  }
  ++unacknowledged_;
}

}  // namespace scarab::log
