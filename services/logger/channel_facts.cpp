#include "services/logger/channel_facts.hpp"

#include <spdlog/spdlog.h>

#include <set>

#include "common/bus/error.hpp"
#include "common/bus/raw_qos.hpp"
#include "common/bus/stored_type.hpp"
#include "common/bus/topic_type.hpp"
#include "common/bus/topics.hpp"
#include "common/sample/idl_text.hpp"
#include "common/sample/type_model.hpp"
#include "services/logger/core/base64.hpp"

namespace scarab::logger {
namespace {

/// The IDL for the log; a type that the log's readers could not take is recorded as bytes alone.
std::string schema_text(const bus::TopicType& type, const std::string& topic) {
  try {
    return sample::idl_text(bus::model_of(*type));
  } catch (const bus::Error& error) {
    spdlog::warn("{} is recorded without a schema: {}", topic, error.what());
    return "";
  }
}

std::string in_base64(const sample::Bytes& bytes) {
  return base64(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

void add_type(const bus::TopicType& type, std::map<std::string, std::string>& metadata) {
  try {
    const bus::StoredType stored = bus::store_type(*type);
    metadata["type_information"] = in_base64(stored.information);
    metadata["type_mapping"] = in_base64(stored.mapping);
  } catch (const bus::Error&) {
    // A type that carries none: whoever publishes the topic again has to know it.
  }
}

std::string names_of(const std::vector<bus::DiscoveredEndpoint>& writers) {
  std::set<bus::Peer> peers;
  for (const bus::DiscoveredEndpoint& writer : writers) {
    if (!writer.peer.service.empty()) peers.insert(writer.peer);
  }
  std::string names;
  for (const bus::Peer& peer : peers) names += (names.empty() ? "" : " ") + bus::to_string(peer);
  return names;
}

TopicRole role_of(const std::string& topic) {
  if (topic == bus::kRobotState.name) return TopicRole::kProgress;
  if (topic == bus::kTrial.name) return TopicRole::kTrial;
  bool own = false;
  bus::for_each_topic([&](const auto& known) { own = own || topic == known.name; });
  return own ? TopicRole::kChain : TopicRole::kNone;
}

}  // namespace

ChannelSpec describe_channel(const std::vector<bus::DiscoveredEndpoint>& writers,
                             const bus::TopicType& type) {
  const bus::DiscoveredEndpoint& first = writers.at(0);
  ChannelSpec spec{
      first.topic, first.type, schema_text(type, first.topic), role_of(first.topic), {}};
  spec.metadata["type"] = first.type;
  spec.metadata["writers"] = names_of(writers);
  for (const auto& [word, value] : bus::to_words(bus::raw_qos_of(*first.qos))) {
    spec.metadata["qos." + word] = value;
  }
  add_type(type, spec.metadata);
  return spec;
}

}  // namespace scarab::logger
