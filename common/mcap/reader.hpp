#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <string>

#include "common/mcap/error.hpp"
#include "common/mcap/input_file.hpp"
#include "common/mcap/scan.hpp"
#include "common/mcap/summary.hpp"

namespace scarab::mcap {

class RecordStream;

/// How a Reader learns what a file contains.
enum class Access {
  kIndexed,  ///< from the summary at its end; from a scan when it has none, was cut, or its summary
             ///< is damaged or leaves something out
  kScan,     ///< always from front to back, believing nothing but CRCs
};

/// Reads one MCAP file, of this writer or any other, with or without chunks and summary, closed or
/// not. A file that was never closed yields every complete chunk. Memory is that of a chunk.
class Reader {
 public:
  /// Throws FileError (cannot be opened) and FormatError (no MCAP file).
  explicit Reader(const std::filesystem::path& path, Access access = Access::kIndexed,
                  const Progress& progress = {});

  /// True when the file was closed by its writer; false for one that was cut or is still being
  /// written.
  bool closed() const { return closed_; }
  /// What is wrong with it in words, empty when nothing was found. A closed file's chunks are
  /// checked as they are read.
  const std::string& damage() const { return damage_; }
  /// Whole records that the scan found damaged and that are left out.
  std::size_t damaged() const { return damaged_.size(); }
  /// Bytes at the end that no whole record covers: the chunk a kill cut short.
  std::uint64_t bytes_lost() const { return bytes_lost_; }

  const Header& header() const { return header_; }
  const Summary& summary() const { return summary_; }

  using Visitor = std::function<void(const Channel&, const Message&)>;
  /// Visits the messages in the order they were written; only those of `topics` when any are given.
  /// Throws FormatError, naming file and place, for a damaged chunk that the scan has not already
  /// left out.
  void for_each(const Visitor& visit, const std::set<std::string>& topics = {}) const;
  /// True: go on.
  using Judge = std::function<bool(const Channel&, const Message&)>;
  /// The same up to where `visit` says false; false then.
  bool for_each_while(const Judge& visit, const std::set<std::string>& topics = {}) const;

  /// Throws FormatError when its CRC is wrong.
  Attachment attachment(const AttachmentIndex& index) const;
  Metadata metadata(const MetadataIndex& index) const;
  /// Content of the record at `offset` with `length` (as in an index), for tools that look at
  /// single records.
  Bytes record(std::uint64_t offset, std::uint64_t length) const;
  const std::filesystem::path& path() const { return file_.path(); }

 private:
  bool read_summary();
  void read_by_scan(const Progress& progress);
  bool visit_record(RecordStream& stream, const std::set<std::uint16_t>& channels,
                    const Judge& visit) const;
  bool visit_chunk(ByteView content, const std::set<std::uint16_t>& channels,
                   const Judge& visit) const;
  bool wanted(std::uint64_t chunk_offset, const std::set<std::uint16_t>& channels) const;

  InputFile file_;
  Header header_;
  std::uint64_t data_begin_ = 0;
  std::uint64_t data_end_ = 0;
  Summary summary_;
  std::set<std::uint64_t> damaged_;
  std::string damage_;
  std::uint64_t bytes_lost_ = 0;
  bool closed_ = false;
};

}  // namespace scarab::mcap
