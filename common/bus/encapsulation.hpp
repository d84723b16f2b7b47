#pragma once

#include <cstddef>

#include "common/bus/raw_cdr.hpp"

namespace scarab::bus {

/// What the four bytes before every serialised sample say (RTPS 2.5, 10.2;
/// DDS-XTypes 1.3, 7.6.3.1.2).
struct Encapsulation {
  static constexpr std::size_t kSize = 4;

  bool xcdr2 = false;    ///< else XCDR1
  bool swapped = false;  ///< the other byte order than this machine's
};

/// Throws Error for less than four bytes, and for parameter lists (mutable types) and what is no
/// CDR.
Encapsulation encapsulation_of(ByteView cdr);

}  // namespace scarab::bus
