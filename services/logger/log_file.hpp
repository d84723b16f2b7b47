#pragma once

#include <filesystem>
#include <memory>

#include "common/mcap/writer.hpp"
#include "services/logger/config.hpp"
#include "services/logger/options.hpp"
#include "services/logger/recording.hpp"

namespace scarab::logger {

/// `wanted`, or the first of `name-2.mcap`, `name-3.mcap`, ... of which neither the file nor its
/// `.active` exists: what a recorder killed before has left is never overwritten.
std::filesystem::path free_name(const std::filesystem::path& wanted);

/// Creates the log with its attachments and the metadata record `scarab.recording` (version, host,
/// start). Throws mcap::FileError.
std::unique_ptr<mcap::Writer> open_log(const LoggerOptions& options, const LoggerConfig& config);

/// The metadata record `scarab.recorded`: what the log holds, written at its end.
mcap::Metadata closing_metadata(const RecordingState& state);

}  // namespace scarab::logger
