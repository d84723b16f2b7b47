#include "common/mcap/crc32.hpp"

#include <array>

namespace scarab::mcap {
namespace {

constexpr std::size_t kSlices = 16;
using Tables = std::array<std::array<std::uint32_t, 256>, kSlices>;

/// Table s gives the CRC of one byte followed by s zero bytes, so that sixteen bytes take sixteen
/// independent look-ups.
constexpr Tables make_tables() {
  constexpr std::uint32_t kReflectedPolynomial = 0xEDB88320U;
  Tables tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t crc = byte;
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? kReflectedPolynomial : 0U);
    }
    tables[0][byte] = crc;
  }
  for (std::size_t slice = 1; slice < kSlices; ++slice) {
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint32_t before = tables[slice - 1][byte];
      tables[slice][byte] = (before >> 8U) ^ tables[0][before & 0xFFU];
    }
  }
  return tables;
}

constexpr Tables kTables = make_tables();

}  // namespace

void Crc32::update(ByteView bytes) {
  std::uint32_t crc = state_;
  const std::uint8_t* p = bytes.data();
  std::size_t left = bytes.size();
  for (; left >= kSlices; left -= kSlices, p += kSlices) {
    crc = kTables[15][(p[0] ^ crc) & 0xFFU] ^ kTables[14][(p[1] ^ (crc >> 8U)) & 0xFFU] ^
          kTables[13][(p[2] ^ (crc >> 16U)) & 0xFFU] ^ kTables[12][(p[3] ^ (crc >> 24U)) & 0xFFU] ^
          kTables[11][p[4]] ^ kTables[10][p[5]] ^ kTables[9][p[6]] ^ kTables[8][p[7]] ^
          kTables[7][p[8]] ^ kTables[6][p[9]] ^ kTables[5][p[10]] ^ kTables[4][p[11]] ^
          kTables[3][p[12]] ^ kTables[2][p[13]] ^ kTables[1][p[14]] ^ kTables[0][p[15]];
  }
  for (; left > 0; --left, ++p) {
    crc = (crc >> 8U) ^ kTables[0][(crc ^ *p) & 0xFFU];
  }
  state_ = crc;
}

std::uint32_t crc32(ByteView bytes) {
  Crc32 crc;
  crc.update(bytes);
  return crc.value();
}

}  // namespace scarab::mcap
