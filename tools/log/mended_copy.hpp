#pragma once

#include "common/mcap/reader.hpp"

namespace scarab::log {

/// True when `copy` is what `recover` has made of `original`, a file beside it: both have the same
/// messages, and who reads both reads each of them twice.
bool is_mended_copy(const mcap::Reader& copy, const mcap::Reader& original);

}  // namespace scarab::log
