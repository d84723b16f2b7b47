#pragma once

#include "common/sample/type_model.hpp"

/// Where XCDR2 writes the length of a part before it (DDS-XTypes 1.3, 7.4.3.5.3, DHEADER); XCDR1
/// never does.
namespace scarab::sample {

/// A struct that may grow.
bool is_delimited(const StructType& type);
/// A list whose elements are not primitive. Arrays of arrays are one array to Cyclone, with
/// typedefs in between as without: only the outermost has a length before it.
bool is_delimited(const ArrayType& type);
bool is_delimited(const SequenceType& type);

/// True for a type with a part that may grow, which Cyclone writes and reads in XCDR2 only.
bool needs_xcdr2(const Type& type);

}  // namespace scarab::sample
