#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "common/mcap/writer.hpp"

namespace scarab::mcap {

struct Recovery {
  std::uint64_t messages = 0;
  std::uint32_t chunks = 0;
  std::uint32_t attachments = 0;
  std::uint64_t bytes_lost = 0;  ///< after the last whole record
  std::string damage;            ///< the first damaged record that was left out; empty when none
};

/// Writes everything that can be read of `from`, a file cut or damaged, into a new, closed file
/// `to`: messages in order, attachments, metadata, and a metadata record `scarab.recovered` that
/// says where it comes from. Throws FileError and FormatError (no MCAP file).
Recovery recover(const std::filesystem::path& from, const std::filesystem::path& to,
                 const WriterOptions& options = {});

}  // namespace scarab::mcap
