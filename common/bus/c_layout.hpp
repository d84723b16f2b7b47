#pragma once

#include <cstddef>
#include <vector>

#include "common/sample/type_model.hpp"

namespace scarab::bus {

/// Size and alignment, in bytes, of the C type that idlc makes of an IDL type.
struct CLayout {
  std::size_t size = 0;
  std::size_t alignment = 1;
};

CLayout c_layout(const sample::Type& type);

/// Where each member begins in the C struct.
std::vector<std::size_t> member_offsets(const sample::StructType& type);

}  // namespace scarab::bus
