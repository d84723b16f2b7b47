#include "common/mcap/record_stream.hpp"

#include <algorithm>

namespace scarab::mcap {

/// The bytes in the block read last, or in one that is read for them.
ByteView RecordStream::bytes(std::uint64_t offset, std::uint64_t length) {
  constexpr std::uint64_t kBlock = 64U * 1024U;
  const bool is_there = offset >= block_begin_ && offset - block_begin_ <= block_.size() &&
                        length <= block_.size() - (offset - block_begin_);
  if (!is_there) {
    const std::uint64_t size = std::max(length, std::min(kBlock, end_ - offset));
    block_.resize(static_cast<std::size_t>(size));
    block_begin_ = offset;
    file_.read(offset, block_);
  }
  return ByteView(block_).slice(static_cast<std::size_t>(offset - block_begin_),
                                static_cast<std::size_t>(length));
}

bool RecordStream::next() {
  if (end_ - next_ < kRecordPrefix) {
    return false;
  }
  const RecordPrefix prefix = decode_prefix(bytes(next_, kRecordPrefix));
  if (prefix.length > end_ - next_ - kRecordPrefix) {
    return false;
  }
  prefix_ = prefix;
  offset_ = next_;
  next_ += length();
  return true;
}

}  // namespace scarab::mcap
