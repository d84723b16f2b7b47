#include "services/logger/core/sample_header.hpp"

namespace scarab::logger {
namespace {

template <class Int>
Int read(const std::uint8_t* bytes, bool little_endian) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < sizeof(Int); ++i) {
    value = (value << 8U) | bytes[little_endian ? sizeof(Int) - 1 - i : i];
  }
  return static_cast<Int>(value);
}

}  // namespace

std::optional<SampleHeader> read_sample_header(const std::uint8_t* cdr, std::size_t size) {
  constexpr std::uint8_t kPlainBigEndian = 0;
  constexpr std::uint8_t kPlainLittleEndian = 1;
  if (size < kStampEnd || cdr[0] != 0 ||
      (cdr[1] != kPlainBigEndian && cdr[1] != kPlainLittleEndian)) {
    return std::nullopt;
  }
  const bool little = cdr[1] == kPlainLittleEndian;
  const std::uint8_t* payload = cdr + kEncapsulationSize;
  return SampleHeader{
      read<std::uint32_t>(payload, little), read<std::uint32_t>(payload + 4, little),
      read<std::int64_t>(payload + 8, little), read<std::int64_t>(payload + 16, little)};
}

}  // namespace scarab::logger
