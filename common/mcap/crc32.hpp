#pragma once

#include <cstdint>

#include "common/mcap/bytes.hpp"

namespace scarab::mcap {

/// Running CRC-32 as in zlib and Ethernet (polynomial 0x04C11DB7 reflected, start and final
/// inversion), the one MCAP means. CRC-32 of "123456789" is 0xCBF43926.
class Crc32 {
 public:
  void update(ByteView bytes);
  std::uint32_t value() const { return ~state_; }

 private:
  std::uint32_t state_ = 0xFFFFFFFFU;
};

/// CRC-32 of `bytes` alone.
std::uint32_t crc32(ByteView bytes);

}  // namespace scarab::mcap
