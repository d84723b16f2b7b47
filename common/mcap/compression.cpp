#include "common/mcap/compression.hpp"

#include <zstd.h>

#include "common/mcap/error.hpp"

namespace scarab::mcap {

namespace {
constexpr std::uint64_t kLargestChunk = std::uint64_t{1} << 30U;
}  // namespace

std::string name_of(Compression compression) {
  return compression == Compression::kZstd ? "zstd" : "";
}

Bytes compress(Compression compression, int level, ByteView bytes) {
  if (compression == Compression::kNone) {
    return copy_of(bytes);
  }
  Bytes out(ZSTD_compressBound(bytes.size()));
  const std::size_t size = ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), level);
  if (ZSTD_isError(size) != 0U) {
    throw Error(std::string("zstd cannot compress a chunk: ") + ZSTD_getErrorName(size));
  }
  out.resize(size);
  return out;
}

Bytes decompress(const std::string& method, std::uint64_t size, ByteView bytes) {
  if (size > kLargestChunk) {
    throw FormatError("a chunk claims " + std::to_string(size) + " bytes, more than 1 GiB");
  }
  if (method.empty()) {
    if (bytes.size() != size) {
      throw FormatError("an uncompressed chunk does not have the size it claims");
    }
    return copy_of(bytes);
  }
  if (method != "zstd") {
    throw FormatError("chunk compression \"" + method + "\" is not supported (zstd and none are)");
  }
  // Before anything is allocated: a damaged length field must not cost a gigabyte.
  if (ZSTD_getFrameContentSize(bytes.data(), bytes.size()) == ZSTD_CONTENTSIZE_ERROR) {
    throw FormatError("damaged zstd chunk: no zstd frame");
  }
  Bytes out(static_cast<std::size_t>(size));
  const std::size_t written = ZSTD_decompress(out.data(), out.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(written) != 0U) {
    throw FormatError(std::string("damaged zstd chunk: ") + ZSTD_getErrorName(written));
  }
  if (written != out.size()) {
    throw FormatError("a zstd chunk does not have the size it claims");
  }
  return out;
}

}  // namespace scarab::mcap
