#pragma once

#include <cstdint>
#include <filesystem>

#include "tests/unit/mcap/temporary_folder.hpp"

namespace scarab::logger::test {

struct ChunkCount {
  std::uint64_t chunks = 0;
  std::uint64_t messages = 0;  ///< by the message indexes behind the chunks
};

/// What a file that may be cut holds, counted without the project's reader: from record to record
/// by the lengths they say (https://mcap.dev/spec), opening none.
inline ChunkCount count_chunks(const std::filesystem::path& path) {
  constexpr std::size_t kMagic = 8;
  constexpr std::size_t kPrefix = 9;
  constexpr std::uint8_t kChunk = 6;
  constexpr std::uint8_t kMessageIndex = 7;
  constexpr std::size_t kIndexEntry = 16;
  const mcap::Bytes bytes = mcap::test::read_file(path);
  const auto number = [&](std::size_t at, std::size_t size) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i) {
      value |= std::uint64_t{bytes.at(at + i)} << (8 * i);
    }
    return value;
  };
  ChunkCount count;
  std::size_t at = kMagic;
  while (at + kPrefix <= bytes.size() && number(at + 1, 8) <= bytes.size() - at - kPrefix) {
    if (bytes[at] == kChunk) ++count.chunks;
    // Channel id, then the array's length in bytes.
    if (bytes[at] == kMessageIndex) count.messages += number(at + kPrefix + 2, 4) / kIndexEntry;
    at += kPrefix + number(at + 1, 8);
  }
  return count;
}

}  // namespace scarab::logger::test
