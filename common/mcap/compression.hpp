#pragma once

#include <string>

#include "common/mcap/bytes.hpp"

namespace scarab::mcap {

/// How the records of a chunk are stored. lz4, which MCAP also knows, is neither written nor read.
enum class Compression { kNone, kZstd };

/// The name that stands in the file: "" or "zstd".
std::string name_of(Compression compression);

/// `bytes` compressed; `level` is zstd's (1 fastest .. 19 smallest), ignored for kNone.
Bytes compress(Compression compression, int level, ByteView bytes);

/// The `size` bytes that `bytes` was made from. Throws FormatError when the method is unknown, the
/// frame is damaged or the size is another one. Never allocates more than 1 GiB, whatever `size` a
/// damaged file claims.
Bytes decompress(const std::string& method, std::uint64_t size, ByteView bytes);

}  // namespace scarab::mcap
