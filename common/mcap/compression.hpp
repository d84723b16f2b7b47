#pragma once

#include <string>

#include "common/mcap/bytes.hpp"

namespace scarab::mcap {

/// How the records of a chunk are stored: every method MCAP's specification names.
enum class Compression { kNone, kLz4, kZstd };

/// The name that stands in the file: "", "lz4" or "zstd".
std::string name_of(Compression compression);

/// `bytes` as one frame. `level`: zstd 1 (fastest) to 19 (smallest); lz4 1 and 2 (fastest) and 3 to
/// 12 (smallest), more counts as 12; ignored for kNone.
Bytes compress(Compression compression, int level, ByteView bytes);

/// The `size` bytes that `bytes` was made from. Throws FormatError when the method is unknown, the
/// frame is damaged or the size is another one. Never allocates more than 1 GiB, whatever `size` a
/// damaged file claims.
Bytes decompress(const std::string& method, std::uint64_t size, ByteView bytes);

}  // namespace scarab::mcap
