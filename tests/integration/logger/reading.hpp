#pragma once

#include <array>
#include <random>

#include "common/bus/cdr.hpp"
#include "common/bus/clock.hpp"
#include "common/mcap/bytes.hpp"
#include "tests/integration/logger/meadow_topic.hpp"

namespace scarab::logger::test {

/// The noise of the reading of that number: five random bits a byte, which takes a compressor long.
inline std::array<std::uint8_t, sizeof(meadow_Reading::noise)> noise_of(std::uint32_t number) {
  std::array<std::uint8_t, sizeof(meadow_Reading::noise)> noise{};
  std::minstd_rand generator(number + 1);
  for (std::uint8_t& byte : noise) byte = static_cast<std::uint8_t>((generator() >> 8U) & 31U);
  return noise;
}

/// A reading of this moment, as bytes.
inline sample::Bytes encode_reading(std::uint32_t number) {
  meadow_Reading reading{number, bus::now_ns(), {}};
  const auto noise = noise_of(number);
  std::copy(noise.begin(), noise.end(), std::begin(reading.noise));
  return bus::encode(reading);
}

/// Throws bus::Error for bytes that are no reading, or one whose noise is not that of its number.
inline meadow_Reading decode_reading(mcap::ByteView cdr) {
  const auto reading =
      bus::decode<meadow_Reading>({reinterpret_cast<const std::byte*>(cdr.data()), cdr.size()});
  const auto noise = noise_of(reading->number);
  if (!std::equal(noise.begin(), noise.end(), std::begin(reading->noise))) {
    throw bus::Error("reading " + std::to_string(reading->number) + " is not as it was written");
  }
  return *reading;
}

}  // namespace scarab::logger::test
