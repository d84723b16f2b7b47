#pragma once

#include <cstdint>

#include "common/mcap/bytes.hpp"

/// Changes to the chain's Header (idl/scarab/header.idl) that begins a sample, in its CDR bytes of
/// either byte order; those are long enough to have one.
namespace scarab::log {

void set_trial(mcap::Bytes& cdr, std::uint32_t trial);
void set_stamp(mcap::Bytes& cdr, std::int64_t stamp_ns);

}  // namespace scarab::log
