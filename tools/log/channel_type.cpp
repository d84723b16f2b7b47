#include "tools/log/channel_type.hpp"

#include "common/bus/error.hpp"
#include "common/bus/known_types.hpp"
#include "common/bus/topic_type.hpp"
#include "common/sample/idl_parser.hpp"
#include "tools/log/ros_message.hpp"

namespace scarab::log {
namespace {

/// A type of the project's own, of which nothing but the name is written.
bool is_known(const mcap::Schema& schema) {
  return schema.data.empty() && bus::find_known_type(schema.name) != nullptr;
}

/// Sets the type, or why there is none.
void find_type(const mcap::Schema& schema, LogChannel& channel) {
  if (is_known(schema)) {
    channel.type = bus::model_of(*bus::find_known_type(schema.name));
    return;
  }
  try {
    if (schema.encoding == "omgidl") {
      channel.type = sample::parse_idl(schema.data, schema.name);
    } else if (schema.encoding == "ros2msg") {
      channel.type = parse_ros_message(schema.data, schema.name);
    } else {
      channel.no_type = "its schema is in '" + schema.encoding + "', which is not read here";
    }
  } catch (const bus::Error& error) {
    channel.no_type = "its schema cannot be used: " + std::string(error.what());
  }
}

}  // namespace

LogChannel read_channel(const mcap::Channel& record, const mcap::Schema* schema) {
  LogChannel channel;
  channel.topic = record.topic;
  channel.record = record;
  const auto type = record.metadata.find("type");
  if (schema != nullptr) {
    channel.type_name = schema->name;
  } else if (type != record.metadata.end()) {
    channel.type_name = type->second;
  }
  if (record.message_encoding != "cdr") {
    channel.no_type =
        "its messages are in '" + record.message_encoding + "', which is not read here";
  } else if (schema == nullptr || (schema->encoding.empty() && !is_known(*schema))) {
    channel.no_type = "it was recorded without a schema";
  } else {
    find_type(*schema, channel);
  }
  channel.has_header = channel.type && begins_with_header(*channel.type);
  return channel;
}

bool begins_with_header(const sample::TypeModel& type) {
  if (type.root().members.empty()) return false;
  const sample::Type& first = sample::resolve(*type.root().members.front().type);
  const auto* header = std::get_if<sample::StructType>(&first.kind);
  return header != nullptr && header->name == "scarab::Header";
}

}  // namespace scarab::log
