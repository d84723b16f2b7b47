#include "common/mcap/record_stream.hpp"

namespace scarab::mcap {

bool RecordStream::next() {
  if (end_ - next_ < kRecordPrefix) {
    return false;
  }
  const RecordPrefix prefix = decode_prefix(file_.read(next_, kRecordPrefix));
  if (prefix.length > end_ - next_ - kRecordPrefix) {
    return false;
  }
  prefix_ = prefix;
  offset_ = next_;
  next_ += length();
  return true;
}

}  // namespace scarab::mcap
