#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace scarab::logger {

/// The Header that begins every sample of the chain (idl/scarab/header.idl), read from its raw CDR
/// bytes.
struct SampleHeader {
  std::uint32_t trial = 0;
  std::uint32_t tick = 0;
  std::int64_t sim_time_ns = 0;
  std::int64_t stamp_ns = 0;
};

/// Bytes of the encapsulation header before the payload.
inline constexpr std::size_t kEncapsulationSize = 4;
/// Where the wall-clock stamp stands, from the start of the bytes: the one field in which equal
/// runs differ.
inline constexpr std::size_t kStampBegin = kEncapsulationSize + 16;
inline constexpr std::size_t kStampEnd = kStampBegin + 8;

/// The header of a sample whose type begins with one, from its CDR bytes with encapsulation header,
/// of either byte order. Nothing when the bytes are too few or the encapsulation is not plain CDR.
std::optional<SampleHeader> read_sample_header(const std::uint8_t* cdr, std::size_t size);

}  // namespace scarab::logger
