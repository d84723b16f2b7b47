#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "common/mcap/scan.hpp"
#include "common/mcap/writer.hpp"

namespace scarab::mcap {

/// The metadata record of a file that recover() has made, and what in it names the old file.
inline constexpr const char* kRecovered = "scarab.recovered";
inline constexpr const char* kRecoveredFrom = "from";

struct Recovery {
  Statistics kept;               ///< what the new file has; its chunks as they were in the old one
  std::uint64_t bytes_lost = 0;  ///< after the last whole record
  std::size_t damaged = 0;       ///< whole records that were left out: a wrong CRC and the like
  std::string damage;            ///< the first of them in words; empty when none
  /// Messages that gaps in `sequence` tell of, by topic: dropped by the recorder, or in a damaged
  /// record. Those before the first and after the last kept one leave no gap. Topics that lack none
  /// are not listed. Known of the project's own recordings only (metadata `scarab.recording`).
  std::map<std::string, std::uint64_t> missing;
  bool was_closed = false;  ///< the old file's writer had finished it
};

/// What recover() calls the new file while it writes it: of a process killed meanwhile this is left
/// over, and in nobody's way.
std::filesystem::path unfinished_path(const std::filesystem::path& to);

/// Writes everything that can be read of `from`, a file cut or damaged, into a new, closed file
/// `to`: messages in order, attachments, metadata, and a metadata record `scarab.recovered` that
/// says where it comes from and how many messages are missing, in all and of each topic. `to`
/// appears once it is whole, and never takes the place of another file, unless `options` say so.
/// Throws FileError (`to` exists, disk full, ...) and FormatError (no MCAP file); then there is no
/// trace of it.
Recovery recover(const std::filesystem::path& from, const std::filesystem::path& to,
                 const WriterOptions& options = {}, const Progress& progress = {});

}  // namespace scarab::mcap
