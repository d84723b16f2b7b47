#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>

#include "common/mcap/input_file.hpp"
#include "common/mcap/summary.hpp"

namespace scarab::mcap {

/// What reading a file from front to back finds, without its summary.
struct Scan {
  Summary summary;
  bool complete = false;            ///< the data section's end was reached
  std::uint64_t readable_size = 0;  ///< bytes up to the end of the last whole record
  /// Offsets of chunks and attachments that are whole but damaged (CRC, compression, record
  /// lengths); not in the summary.
  std::set<std::uint64_t> damaged;
  std::string first_damage;  ///< the first of them in words; empty when there is none
};

/// Is told of a scan how many bytes of how many are done, after each record.
using Progress = std::function<void(std::uint64_t done, std::uint64_t total)>;

/// Reads the data section of a file whose header ends at `begin`. Never throws for what the file
/// contains.
Scan scan(const InputFile& file, std::uint64_t begin, const Progress& progress = {});

/// The uncompressed records of a chunk. Throws FormatError when the CRC or the compression is
/// wrong.
Bytes unpack(const Chunk& chunk);

}  // namespace scarab::mcap
