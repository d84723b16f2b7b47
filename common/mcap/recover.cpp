#include "common/mcap/recover.hpp"

#include <map>

#include "common/mcap/reader.hpp"

namespace scarab::mcap {
namespace {

/// Ids of the new file for those of the old one.
std::map<std::uint16_t, std::uint16_t> copy_channels(const Summary& from, Writer& to) {
  std::map<std::uint16_t, std::uint16_t> schema_ids{{std::uint16_t{0}, std::uint16_t{0}}};
  for (const auto& [id, schema] : from.schemas) {
    schema_ids[id] = to.add_schema(schema.name, schema.encoding, schema.data);
  }
  std::map<std::uint16_t, std::uint16_t> channel_ids;
  for (const auto& [id, channel] : from.channels) {
    const auto schema = schema_ids.find(channel.schema_id);
    channel_ids[id] = to.add_channel(schema == schema_ids.end() ? std::uint16_t{0} : schema->second,
                                     channel.topic, channel.message_encoding, channel.metadata);
  }
  return channel_ids;
}

}  // namespace

Recovery recover(const std::filesystem::path& from, const std::filesystem::path& to,
                 const WriterOptions& options) {
  const Reader reader(from, Access::kScan);
  WriterOptions same_profile = options;
  same_profile.profile = reader.header().profile;
  Writer writer(to, same_profile);

  for (const AttachmentIndex& index : reader.summary().attachments) {
    writer.attach(reader.attachment(index));
  }
  for (const MetadataIndex& index : reader.summary().metadata) {
    writer.add_metadata(reader.metadata(index));
  }
  auto channel_ids = copy_channels(reader.summary(), writer);
  reader.for_each([&](const Channel& channel, const Message& message) {
    Message copy = message;
    copy.channel_id = channel_ids.at(channel.id);
    writer.write(copy);
  });

  const Recovery result{writer.statistics().message_count, reader.summary().statistics.chunk_count,
                        reader.summary().statistics.attachment_count, reader.bytes_lost(),
                        reader.damage()};
  writer.add_metadata({"scarab.recovered",
                       {{"from", from.filename().string()},
                        {"bytes_lost", std::to_string(result.bytes_lost)},
                        {"damage", result.damage}}});
  writer.close();
  return result;
}

}  // namespace scarab::mcap
