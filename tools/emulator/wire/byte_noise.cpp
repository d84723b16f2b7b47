#include "tools/emulator/wire/byte_noise.hpp"

#include "common/random/random.hpp"

namespace scarab::emulator {
namespace {

constexpr std::uint64_t kLose = random::stream("lose");
constexpr std::uint64_t kFlip = random::stream("flip");
constexpr std::uint64_t kWhichBit = random::stream("flip which bit");

}  // namespace

ByteNoise::ByteNoise(std::uint64_t seed, std::string_view direction)
    : seed_(seed), stream_(random::stream(direction)) {}

std::optional<std::uint8_t> ByteNoise::pass(std::uint8_t byte, double lose, double flip) {
  const std::uint64_t n = index_++;
  if (random::uniform(seed_, stream_ ^ kLose, n) < lose) return std::nullopt;
  if (random::uniform(seed_, stream_ ^ kFlip, n) >= flip) return byte;
  const auto bit = random::bits(seed_, stream_ ^ kWhichBit, n) % 8;
  return static_cast<std::uint8_t>(byte ^ (1U << bit));
}

}  // namespace scarab::emulator
