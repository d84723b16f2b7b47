#include "tools/log/topic_type.hpp"

#include "common/bus/known_types.hpp"

namespace scarab::log {

const mcap::Channel* find_channel(const mcap::Reader& reader, const std::string& topic) {
  for (const auto& [id, channel] : reader.summary().channels) {
    if (channel.topic == topic) return &channel;
  }
  return nullptr;
}

std::optional<bus::TypeModel> find_type(const mcap::Reader& reader, const std::string& topic) {
  const mcap::Channel* channel = find_channel(reader, topic);
  if (channel == nullptr) return std::nullopt;
  const auto schema = reader.summary().schemas.find(channel->schema_id);
  if (schema == reader.summary().schemas.end()) return std::nullopt;
  const dds_topic_descriptor_t* known = bus::find_known_type(schema->second.name);
  if (known == nullptr) return std::nullopt;
  return bus::TypeModel::from_descriptor(*known);
}

bool begins_with_header(const bus::TypeModel& type) {
  if (type.root().members.empty()) return false;
  const bus::Type& first = bus::resolve(*type.root().members.front().type);
  const auto* header = std::get_if<bus::StructType>(&first.kind);
  return header != nullptr && header->name == "scarab::Header";
}

}  // namespace scarab::log
