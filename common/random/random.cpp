#include "common/random/random.hpp"

#include <cmath>

namespace scarab::random {
namespace {

constexpr std::uint64_t kGoldenGamma = 0x9e3779b97f4a7c15ULL;  // 2^64 / golden ratio, odd

constexpr double kTwoPi = 6.283185307179586476925;
constexpr std::uint64_t kRadius = stream("gaussian radius");
constexpr std::uint64_t kAngle = stream("gaussian angle");

std::uint64_t mix(std::uint64_t value) {
  value += kGoldenGamma;  // the finaliser alone maps 0 to 0
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ULL;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebULL;
  return value ^ (value >> 31);
}

}  // namespace

std::uint64_t bits(std::uint64_t seed, std::uint64_t stream, std::uint64_t index) {
  return mix(mix(mix(seed) ^ stream) ^ index);
}

double uniform(std::uint64_t seed, std::uint64_t stream, std::uint64_t index) {
  return static_cast<double>(bits(seed, stream, index) >> 11) * 0x1p-53;
}

double gaussian(std::uint64_t seed, std::uint64_t stream, std::uint64_t index) {
  const double above_zero = 1.0 - uniform(seed, stream ^ kRadius, index);
  const double angle_rad = kTwoPi * uniform(seed, stream ^ kAngle, index);
  return std::sqrt(-2.0 * std::log(above_zero)) * std::cos(angle_rad);
}

}  // namespace scarab::random
