#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "common/mcap/writer.hpp"

namespace scarab::logger {

/// How the recorder records; every key has a default, so that it needs no file.
struct LoggerConfig {
  std::uint64_t chunk_size_kib = 1024;  ///< a chunk is closed beyond this, before compression
  double chunk_time_s = 1.0;            ///< a chunk is closed when its first message is this old
  mcap::Compression compression = mcap::Compression::kZstd;
  int compression_level = 1;  ///< zstd: 1 fastest .. 19 smallest
  std::uint64_t queue_mib =
      64;  ///< samples between the bus and the file; beyond it the bus's queues fill
  double take_interval_s = 0.001;  ///< samples are taken at most this often, several at once
  bool sync_on_close = false;      ///< at the end, wait until the disk has the file
};

/// Reads a file with any of the keys above. Throws config::Error (`file:line:col: key: reason`).
LoggerConfig load_config(const std::filesystem::path& path);

/// YAML that load_config reads back to an equal value.
std::string dump_config(const LoggerConfig& config);

}  // namespace scarab::logger
