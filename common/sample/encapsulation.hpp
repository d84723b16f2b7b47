#pragma once

#include <cstddef>

#include "common/sample/bytes.hpp"

namespace scarab::sample {

/// What the four bytes before every serialised sample say (RTPS 2.5, 10.2;
/// DDS-XTypes 1.3, 7.6.3.1.2).
struct Encapsulation {
  static constexpr std::size_t kSize = 4;

  bool xcdr2 = false;    ///< else XCDR1
  bool swapped = false;  ///< the other byte order than this machine's
  bool is_list = false;  ///< a parameter list of XCDR2: a mutable type
};

/// Throws Error for less than four bytes, and for what is no CDR, or is a parameter list of XCDR1,
/// which Cyclone does not write.
Encapsulation encapsulation_of(ByteView cdr);

}  // namespace scarab::sample
