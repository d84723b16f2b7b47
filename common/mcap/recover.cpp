#include "common/mcap/recover.hpp"

#include <fcntl.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <map>
#include <system_error>

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

/// Which numbers a channel's messages have. Their order in a file is that of time, which is not
/// always that of their numbers.
struct Numbers {
  std::uint64_t count = 0;
  std::uint32_t least = UINT32_MAX;
  std::uint32_t greatest = 0;

  void note(std::uint32_t sequence) {
    ++count;
    least = std::min(least, sequence);
    greatest = std::max(greatest, sequence);
  }
  [[nodiscard]] std::uint64_t missing() const {
    const std::uint64_t numbers = std::uint64_t{greatest} - least + 1;
    return numbers > count ? numbers - count : 0;
  }
};

/// The project's recorder numbers what it takes of a topic; others number as they like, or not.
bool numbers_tell(const Reader& reader) {
  const auto& metadata = reader.summary().metadata;
  return std::any_of(metadata.begin(), metadata.end(),
                     [](const MetadataIndex& index) { return index.name == "scarab.recording"; });
}

std::map<std::string, std::uint64_t> missing_of(const Reader& reader,
                                                const std::map<std::uint16_t, Numbers>& numbers) {
  std::map<std::string, std::uint64_t> missing;
  if (!numbers_tell(reader)) return missing;
  for (const auto& [id, seen] : numbers) {
    const std::uint64_t count = seen.missing();
    if (count > 0) missing[reader.summary().channels.at(id).topic] += count;
  }
  return missing;
}

Metadata recovered_metadata(const Reader& reader, const Recovery& result) {
  Metadata metadata{kRecovered,
                    {{kRecoveredFrom, reader.path().filename().string()},
                     {"bytes_lost", std::to_string(result.bytes_lost)},
                     {"damage", result.damage}}};
  std::uint64_t missing = 0;
  for (const auto& [topic, count] : result.missing) {
    metadata.entries["missing." + topic] = std::to_string(count);
    missing += count;
  }
  metadata.entries["missing"] = std::to_string(missing);
  return metadata;
}

/// Copies everything readable into the writer, and closes it.
Recovery copy(const Reader& reader, Writer& writer) {
  for (const AttachmentIndex& index : reader.summary().attachments) {
    writer.attach(reader.attachment(index));
  }
  for (const MetadataIndex& index : reader.summary().metadata) {
    writer.add_metadata(reader.metadata(index));
  }
  const auto channel_ids = copy_channels(reader.summary(), writer);
  std::map<std::uint16_t, Numbers> numbers;
  reader.for_each([&](const Channel& channel, const Message& message) {
    numbers[channel.id].note(message.sequence);
    Message moved = message;
    moved.channel_id = channel_ids.at(channel.id);
    writer.write(moved);
  });
  Recovery result{writer.statistics(), reader.bytes_lost(), reader.damaged(), reader.damage(), {},
                  reader.closed()};
  result.kept.chunk_count = reader.summary().statistics.chunk_count;
  result.missing = missing_of(reader, numbers);
  writer.add_metadata(recovered_metadata(reader, result));
  writer.close();
  return result;
}

/// Gives a finished file its name, never that of another one.
void move(const std::filesystem::path& from, const std::filesystem::path& to, bool overwrite) {
  const unsigned flags = overwrite ? 0 : RENAME_NOREPLACE;
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), flags) != 0) {
    throw FileError("cannot create " + to.string() + ": " + std::generic_category().message(errno));
  }
}

/// A name of its own: what a Writer calls an unfinished `to` may well be the file that is mended.
std::filesystem::path name_for_writer(const std::filesystem::path& to) {
  return to.string() + ".mending";
}

void remove_traces(const std::filesystem::path& to) {
  std::error_code ignored;
  std::filesystem::remove(name_for_writer(to), ignored);
  std::filesystem::remove(unfinished_path(to), ignored);
}

}  // namespace

std::filesystem::path unfinished_path(const std::filesystem::path& to) {
  return name_for_writer(to).string() + ".active";
}

Recovery recover(const std::filesystem::path& from, const std::filesystem::path& to,
                 const WriterOptions& options, const Progress& progress) {
  const Reader reader(from, Access::kScan, progress);
  if (!options.overwrite && std::filesystem::exists(to)) {
    throw FileError("cannot create " + to.string() + ": it exists");
  }
  WriterOptions own = options;
  own.profile = reader.header().profile;
  own.overwrite = true;
  try {
    Writer writer(name_for_writer(to), own);
    const Recovery result = copy(reader, writer);
    move(name_for_writer(to), to, options.overwrite);
    return result;
  } catch (...) {
    remove_traces(to);
    throw;
  }
}

}  // namespace scarab::mcap
