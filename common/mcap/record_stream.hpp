#pragma once

#include <cstdint>

#include "common/mcap/decode.hpp"
#include "common/mcap/input_file.hpp"

namespace scarab::mcap {

/// Steps through the records of a file from a position on, reading contents only when asked to. The
/// file is read in blocks, so that small records that stand side by side cost no call each.
class RecordStream {
 public:
  /// Records from `begin` up to `end` (both from the start of the file, end <= its size).
  RecordStream(const InputFile& file, std::uint64_t begin, std::uint64_t end)
      : file_(file), next_(begin), end_(end) {}

  /// Goes to the next record; false when no complete record follows.
  bool next();
  Opcode opcode() const { return prefix_.opcode; }
  /// Where the record starts in the file.
  std::uint64_t offset() const { return offset_; }
  /// Its length with opcode and length prefix.
  std::uint64_t length() const { return kRecordPrefix + prefix_.length; }
  /// Valid until next().
  ByteView content() { return bytes(offset_ + kRecordPrefix, prefix_.length); }
  /// Where the last complete record ends.
  std::uint64_t position() const { return next_; }

 private:
  ByteView bytes(std::uint64_t offset, std::uint64_t length);

  const InputFile& file_;
  Bytes block_;
  std::uint64_t block_begin_ = 0;
  std::uint64_t offset_ = 0;
  std::uint64_t next_;
  std::uint64_t end_;
  RecordPrefix prefix_;
};

}  // namespace scarab::mcap
