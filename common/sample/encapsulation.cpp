#include "common/sample/encapsulation.hpp"

#include "common/sample/error.hpp"

namespace scarab::sample {

Encapsulation encapsulation_of(ByteView cdr) {
  if (cdr.size < Encapsulation::kSize) throw Error("no encapsulation header");
  const auto id =
      std::to_integer<unsigned>(cdr.data[0]) << 8U | std::to_integer<unsigned>(cdr.data[1]);
  switch (id) {
    case 0x0000:  // CDR; odd numbers are little-endian, as the machines this project runs on
    case 0x0001:
    case 0x0006:  // PLAIN_CDR2: final types
    case 0x0007:
    case 0x0008:  // DELIMIT_CDR2: appendable types
    case 0x0009:
    case 0x000A:  // PL_CDR2: mutable types
    case 0x000B:
      return {id >= 0x0006, (id & 1U) == 0, id >= 0x000A};
    default:
      throw Error("representation " + std::to_string(id) + " is not plain CDR");
  }
}

}  // namespace scarab::sample
