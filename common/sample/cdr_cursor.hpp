#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "common/sample/bytes.hpp"

namespace scarab::sample {

/// Reads values one after the other from CDR bytes, with their alignment and byte order. Throws
/// Error when the bytes, or those of the delimited part being read, end early.
class CdrCursor {
 public:
  /// `cdr` begins with the encapsulation header.
  explicit CdrCursor(ByteView cdr);

  template <class T>
  T read() {
    align(sizeof(T));
    std::array<std::byte, sizeof(T)> bytes;
    const ByteView raw = take(sizeof(T));
    std::copy_n(raw.data, sizeof(T), bytes.begin());
    if (swapped_) std::reverse(bytes.begin(), bytes.end());
    T value;
    std::memcpy(&value, bytes.data(), sizeof(T));
    return value;
  }

  /// Borrowed text of at most `bound` characters (0: any number).
  std::string_view read_string(std::uint32_t bound);

  /// A number of elements that come next. Each takes at least a byte: an absurd number is refused
  /// before anybody makes room for it.
  std::uint32_t checked_size(std::uint32_t elements) const;

  bool is_xcdr2() const { return largest_alignment_ == 4; }

  /// A part that says its length beforehand (DDS-XTypes 1.3, 7.4.3.5.3: DHEADER). Nothing in it
  /// reads beyond its end, and what is left of it when the object goes is passed over: members that
  /// a newer version of the type has.
  class Delimited {
   public:
    /// `present` false: there is no such header here.
    Delimited(CdrCursor& cursor, bool present);
    Delimited(const Delimited&) = delete;
    Delimited& operator=(const Delimited&) = delete;
    ~Delimited();

   private:
    CdrCursor& cursor_;
    std::size_t outer_end_;
    bool present_;
  };

 private:
  std::size_t left() const { return end_ - at_; }
  void align(std::size_t size);
  ByteView take(std::size_t size);

  ByteView payload_;
  std::size_t at_ = 0;
  std::size_t end_ = 0;  ///< of the innermost delimited part
  bool swapped_ = false;
  std::size_t largest_alignment_ = 8;
};

}  // namespace scarab::sample
