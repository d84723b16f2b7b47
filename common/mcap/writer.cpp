#include "common/mcap/writer.hpp"

#include <limits>
#include <utility>

namespace scarab::mcap {
namespace {

std::filesystem::path active_path(const std::filesystem::path& path) {
  std::filesystem::path active = path;
  active += ".active";
  return active;
}

std::filesystem::path checked_free(std::filesystem::path path, bool overwrite) {
  if (!overwrite && std::filesystem::exists(path)) {
    throw FileError("cannot create " + path.string() + ": it exists");
  }
  // A finished file takes the place of what has its name, and nobody wants to lose /dev/null.
  if (std::filesystem::exists(path) && !std::filesystem::is_regular_file(path)) {
    throw FileError("cannot create " + path.string() + ": it is no regular file");
  }
  return path;
}

template <class Record>
std::uint16_t next_id(const std::map<std::uint16_t, Record>& records, const char* what) {
  if (records.size() >= std::numeric_limits<std::uint16_t>::max()) {
    throw Error(std::string("an MCAP file holds no more than 65535 ") + what);
  }
  return static_cast<std::uint16_t>(records.size() + 1);
}

}  // namespace

Writer::Writer(std::filesystem::path path, WriterOptions options)
    : path_(checked_free(std::move(path), options.overwrite)),
      options_(std::move(options)),
      file_(active_path(path_), options_.overwrite) {
  Bytes start(kMagic.begin(), kMagic.end());
  encode(start, Header{options_.profile, options_.library});
  append(start);
}

void Writer::check_open() const {
  if (!refusal_.empty()) {
    throw FileError(refusal_);
  }
}

void Writer::append(ByteView bytes) {
  try {
    file_.append(bytes);
  } catch (const FileError& error) {
    refusal_ = error.what();
    throw;
  }
}

std::uint16_t Writer::add_schema(std::string name, std::string encoding, std::string data) {
  check_open();
  const std::uint16_t id = next_id(summary_.schemas, "schemas");
  summary_.schemas[id] = {id, std::move(name), std::move(encoding), std::move(data)};
  ++summary_.statistics.schema_count;
  return id;
}

std::uint16_t Writer::add_channel(std::uint16_t schema_id, std::string topic,
                                  std::string message_encoding,
                                  std::map<std::string, std::string> metadata) {
  check_open();
  if (schema_id != 0 && summary_.schemas.count(schema_id) == 0) {
    throw Error("channel " + topic + ": there is no schema " + std::to_string(schema_id));
  }
  const std::uint16_t id = next_id(summary_.channels, "channels");
  summary_.channels[id] = {id, schema_id, std::move(topic), std::move(message_encoding),
                           std::move(metadata)};
  ++summary_.statistics.channel_count;
  return id;
}

void Writer::introduce(std::uint16_t channel_id) {
  const auto found = summary_.channels.find(channel_id);
  if (found == summary_.channels.end()) {
    throw Error("there is no channel " + std::to_string(channel_id));
  }
  const Channel& channel = found->second;
  if (channel.schema_id != 0 && introduced_schemas_.insert(channel.schema_id).second) {
    chunk_.add(summary_.schemas.at(channel.schema_id));
  }
  chunk_.add(channel);
  introduced_channels_.insert(channel_id);
}

void Writer::write(const Message& message) {
  check_open();
  close_chunk_if_due(message.log_time_ns);
  if (introduced_channels_.count(message.channel_id) == 0) {
    introduce(message.channel_id);
  }
  chunk_.add(message);
  summary_.statistics.count(message);
  if (chunk_.size() >= options_.chunk_size_bytes) {
    close_chunk();
  }
}

void Writer::close_chunk_if_due(std::uint64_t now_ns) {
  const auto span = static_cast<std::uint64_t>(options_.chunk_time.count());
  if (!chunk_.empty() && now_ns > chunk_.start_time_ns() &&
      now_ns - chunk_.start_time_ns() >= span) {
    close_chunk();
  }
}

void Writer::close_chunk() {
  check_open();
  if (chunk_.empty()) {
    return;
  }
  Bytes bytes;
  ChunkIndex index =
      chunk_.finish(bytes, file_.size(), options_.compression, options_.compression_level);
  append(bytes);
  summary_.chunks.push_back(std::move(index));
  ++summary_.statistics.chunk_count;
}

void Writer::attach(const Attachment& attachment) {
  check_open();
  Bytes bytes;
  encode(bytes, attachment);
  const std::uint64_t offset = file_.size();
  append(bytes);
  summary_.attachments.push_back({offset, bytes.size(), attachment.log_time_ns,
                                  attachment.create_time_ns, attachment.data.size(),
                                  attachment.name, attachment.media_type});
  ++summary_.statistics.attachment_count;
}

void Writer::add_metadata(const Metadata& metadata) {
  check_open();
  Bytes bytes;
  encode(bytes, metadata);
  const std::uint64_t offset = file_.size();
  append(bytes);
  summary_.metadata.push_back({offset, bytes.size(), metadata.name});
  ++summary_.statistics.metadata_count;
}

/// The summary may only repeat what the data section has, so channels without a message get their
/// records here.
void Writer::write_unused_channels() {
  Bytes bytes;
  for (const auto& [id, schema] : summary_.schemas) {
    if (introduced_schemas_.insert(id).second) {
      encode(bytes, schema);
    }
  }
  for (const auto& [id, channel] : summary_.channels) {
    if (introduced_channels_.insert(id).second) {
      encode(bytes, channel);
    }
  }
  append(bytes);
}

void Writer::close() {
  close_chunk();
  write_unused_channels();
  Bytes end;
  encode_data_end(end, file_.crc());
  append(end);
  append(encode_summary(summary_, file_.size()));
  refusal_ = path_.string() + " is closed";
  file_.finish(path_, options_.sync_on_close);
}

}  // namespace scarab::mcap
