#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace scarab::emulator {

/// Loses and flips bytes of one direction of the line: what happens to the n-th byte is a pure
/// function of (seed, direction, n).
class ByteNoise {
 public:
  ByteNoise(std::uint64_t seed, std::string_view direction);

  /// The next byte as it arrives; none: it is lost. `lose` and `flip` are probabilities per byte.
  std::optional<std::uint8_t> pass(std::uint8_t byte, double lose, double flip);

 private:
  std::uint64_t seed_;
  std::uint64_t stream_;
  std::uint64_t index_ = 0;
};

}  // namespace scarab::emulator
