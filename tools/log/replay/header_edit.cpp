#include "tools/log/replay/header_edit.hpp"

#include "services/logger/core/sample_header.hpp"

namespace scarab::log {
namespace {

template <class Int>
void put(mcap::Bytes& cdr, std::size_t at, Int value) {
  const bool little_endian = (cdr.at(1) & 1U) != 0;
  for (std::size_t i = 0; i < sizeof(Int); ++i) {
    const std::size_t place = little_endian ? i : sizeof(Int) - 1 - i;
    cdr.at(at + place) = static_cast<std::uint8_t>(value >> (8U * i));
  }
}

}  // namespace

void set_trial(mcap::Bytes& cdr, std::uint32_t trial) {
  put(cdr, logger::kEncapsulationSize, trial);
}

void set_stamp(mcap::Bytes& cdr, std::int64_t stamp_ns) {
  put(cdr, logger::kStampBegin, static_cast<std::uint64_t>(stamp_ns));
}

}  // namespace scarab::log
