#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "common/mcap/writer.hpp"

namespace scarab::logger {

/// What goes into one file.
enum class Split { kRun, kTrial };

/// How the recorder records; every key has a default, so that it needs no file.
struct LoggerConfig {
  Split split = Split::kRun;
  std::uint64_t file_size_mib = 0;    ///< beyond it goes on in the next file; 0: no limit
  double file_time_s = 0.0;           ///< the same, of wall time; 0: no limit
  std::uint64_t free_disk_mib = 256;  ///< nothing is written when less is free; 0: whatever is free
  std::uint64_t chunk_size_kib = 1024;  ///< a chunk is closed beyond this, before compression
  double chunk_time_s = 0.5;            ///< a chunk is closed when its first message is this old
  mcap::Compression compression = mcap::Compression::kZstd;
  int compression_level = 1;  ///< 1 fastest .. 19 (lz4: 12) smallest
  std::uint64_t queue_mib =
      64;  ///< samples between the bus and the file; beyond it lockstep waits, real time drops
  double take_interval_s = 0.004;  ///< samples are taken at most this often, several at once
  bool sync_on_close = false;      ///< at the end, wait until the disk has the file
};

/// Reads a file with any of the keys above. Throws config::Error (`file:line:col: key: reason`).
LoggerConfig load_config(const std::filesystem::path& path);

/// YAML that load_config reads back to an equal value.
std::string dump_config(const LoggerConfig& config);

/// JSON Schema of such a file; config/schema/logger.json holds it.
std::string config_schema();

}  // namespace scarab::logger
