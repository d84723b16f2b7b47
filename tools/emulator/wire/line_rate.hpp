#pragma once

#include <cstddef>
#include <cstdint>

namespace scarab::emulator {

/// How fast a serial line is: 8N1, ten bits a byte.
class LineRate {
 public:
  /// `baud` 0: a line that takes no time.
  explicit LineRate(unsigned baud) : baud_(baud) {}

  /// How long `bytes` take, ns; rounded up once, so that no reply is ever faster than its line.
  [[nodiscard]] std::int64_t time_ns(std::size_t bytes) const {
    if (baud_ == 0) return 0;
    constexpr std::int64_t kBitsPerByte = 10;
    constexpr std::int64_t kNsPerS = 1'000'000'000;
    const std::int64_t scaled = static_cast<std::int64_t>(bytes) * kBitsPerByte * kNsPerS;
    return (scaled + baud_ - 1) / baud_;
  }

 private:
  std::int64_t baud_;
};

}  // namespace scarab::emulator
