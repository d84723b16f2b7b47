#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "common/mcap/writer.hpp"
#include "services/logger/config.hpp"
#include "services/logger/log_series.hpp"
#include "services/logger/options.hpp"

namespace scarab::logger {

/// `wanted`, or the first of `name-2.mcap`, `name-3.mcap`, ... of which neither the file nor its
/// `.active` exists: what a recorder killed before has left is never overwritten.
std::filesystem::path free_name(const std::filesystem::path& wanted);

/// The name a part of a recording should have: `output` itself, or with a file for each trial
/// `trial-0001.mcap` for `trial.mcap`, by the trial's number (0000: what was before the first).
std::filesystem::path part_name(const std::filesystem::path& output, Split split,
                                std::uint32_t trial);

/// Creates the files of a recording, each with its attachments and the metadata records
/// `scarab.recording` (version, part, start) and `scarab.host`.
class LogFiles {
 public:
  LogFiles(const LoggerOptions& options, const LoggerConfig& config);

  /// Throws mcap::FileError.
  std::unique_ptr<mcap::Writer> open(const Part& part) const;

 private:
  LoggerOptions options_;
  LoggerConfig config_;
  std::string recording_;  // tells this recording from every other
};

/// The recording of a logger with these options. Throws mcap::FileError.
std::unique_ptr<LogSeries> open_series(const LoggerOptions& options, const LoggerConfig& config);

}  // namespace scarab::logger
