#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "common/mcap/chunk_builder.hpp"
#include "common/mcap/compression.hpp"
#include "common/mcap/error.hpp"
#include "common/mcap/output_file.hpp"
#include "common/mcap/summary.hpp"

namespace scarab::mcap {

struct WriterOptions {
  std::size_t chunk_size_bytes = std::size_t{1}
                                 << 20U;  ///< a chunk is closed beyond this, uncompressed
  std::chrono::nanoseconds chunk_time = std::chrono::seconds(1);  ///< log time a chunk may span
  Compression compression = Compression::kZstd;
  int compression_level = 1;
  std::string profile;  ///< "": no profile of the specification's registry
  std::string library = "scarab";
  bool sync_on_close = false;  ///< close() waits until the disk has the file: safe from a power cut
  bool overwrite = false;      ///< replace an existing file (finished or active) rather than refuse
};

/// Writes one MCAP file: chunks with CRC and message indexes, attachments, metadata, and a summary
/// at the end.
///
/// While it is written the file is called `<path>.active`; close() renames it to `path`. Each chunk
/// is given to the operating system when it is closed, so a process killed at any moment leaves
/// every closed chunk readable (Reader, recover). Errors are exceptions: FileError (disk full, no
/// such folder, file exists). After a FileError from a write the writer refuses everything else
/// with the same message; the closed chunks stay. Not thread-safe.
class Writer {
 public:
  explicit Writer(std::filesystem::path path, WriterOptions options = {});
  /// Without close() before it: the open chunk is lost and the file keeps its name `.active`.
  ~Writer() = default;
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  /// Returns the schema's id, from 1.
  std::uint16_t add_schema(std::string name, std::string encoding, std::string data);
  /// Returns the channel's id, from 1. `schema_id` 0: no schema. Throws Error for an unknown
  /// schema.
  std::uint16_t add_channel(std::uint16_t schema_id, std::string topic,
                            std::string message_encoding,
                            std::map<std::string, std::string> metadata = {});
  /// Adds a message to the open chunk, and closes it when it is full. Throws Error for an unknown
  /// channel.
  void write(const Message& message);
  void attach(const Attachment& attachment);
  void add_metadata(const Metadata& metadata);

  /// Closes the open chunk when its first message is `chunk_time` old at `now_ns`: for writers that
  /// have fallen silent.
  void close_chunk_if_due(std::uint64_t now_ns);
  void close_chunk();
  /// Closes the chunk, writes the summary, renames. Nothing can be written afterwards.
  void close();

  /// What was written so far, the open chunk included.
  const Statistics& statistics() const { return summary_.statistics; }
  /// Bytes in the file, the open chunk not included.
  std::uint64_t file_size() const { return file_.size(); }
  const std::filesystem::path& path() const { return path_; }

 private:
  void append(ByteView bytes);
  void check_open() const;
  void introduce(std::uint16_t channel_id);
  void write_unused_channels();

  std::filesystem::path path_;
  WriterOptions options_;
  OutputFile file_;
  ChunkBuilder chunk_;
  Summary summary_;
  /// Schemas and channels whose record is in the data section already: written before their first
  /// message.
  std::set<std::uint16_t> introduced_schemas_;
  std::set<std::uint16_t> introduced_channels_;
  std::string refusal_;  ///< why nothing more can be written; empty while it can
};

}  // namespace scarab::mcap
