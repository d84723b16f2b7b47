#pragma once

#include <cstdint>
#include <string_view>

/// Counter-based randomness: every number is a pure function of (seed, stream, index) and never of
/// how many numbers were drawn before. So a restarted service, a replica and the in-process
/// composition see the same noise and the same perturbations.
///
/// The mixing function is the 64-bit finaliser "Mix13" of D. Stafford, used as in G. Steele, D.
/// Lea, C. Flood, "Fast splittable pseudorandom number generators" (OOPSLA 2014), once for each
/// argument. Not for cryptography.
namespace scarab::random {

/// The number of a named stream, such as stream("start_yaw"): FNV-1a of the name. Use one stream
/// for each quantity that must be independent of the others.
constexpr std::uint64_t stream(std::string_view name) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char character : name) {
    hash ^= static_cast<unsigned char>(character);
    hash *= 0x100000001b3ULL;
  }
  return hash;
}

/// 64 independent, evenly distributed bits. Integer arithmetic only: the same on every platform.
[[nodiscard]] std::uint64_t bits(std::uint64_t seed, std::uint64_t stream, std::uint64_t index);

/// Uniform in [0, 1), a multiple of 2^-53. The same on every platform.
[[nodiscard]] double uniform(std::uint64_t seed, std::uint64_t stream, std::uint64_t index);

/// Normal with mean 0 and standard deviation 1, by the method of Box and Muller (1958). Uses
/// std::log and std::cos, so the last bit may differ between C libraries (not between processes on
/// one machine). Draws from streams of its own: it is independent of uniform() with the same
/// arguments.
[[nodiscard]] double gaussian(std::uint64_t seed, std::uint64_t stream, std::uint64_t index);

}  // namespace scarab::random
