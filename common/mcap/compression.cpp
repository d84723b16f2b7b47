#include "common/mcap/compression.hpp"

#include <lz4frame.h>
#include <zstd.h>

#include <memory>

#include "common/mcap/error.hpp"

namespace scarab::mcap {

namespace {

constexpr std::uint64_t kLargestChunk = std::uint64_t{1} << 30U;

Bytes compress_zstd(int level, ByteView bytes) {
  Bytes out(ZSTD_compressBound(bytes.size()));
  const std::size_t size = ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), level);
  if (ZSTD_isError(size) != 0U) {
    throw Error(std::string("zstd cannot compress a chunk: ") + ZSTD_getErrorName(size));
  }
  out.resize(size);
  return out;
}

Bytes decompress_zstd(std::size_t size, ByteView bytes) {
  // Before anything is allocated: a damaged length field must not cost a gigabyte.
  if (ZSTD_getFrameContentSize(bytes.data(), bytes.size()) == ZSTD_CONTENTSIZE_ERROR) {
    throw FormatError("damaged zstd chunk: no zstd frame");
  }
  Bytes out(size);
  const std::size_t written = ZSTD_decompress(out.data(), out.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(written) != 0U) {
    throw FormatError(std::string("damaged zstd chunk: ") + ZSTD_getErrorName(written));
  }
  if (written != size) {
    throw FormatError("a zstd chunk does not have the size it claims");
  }
  return out;
}

Bytes compress_lz4(int level, ByteView bytes) {
  LZ4F_preferences_t preferences{};
  preferences.frameInfo.contentSize = bytes.size();
  preferences.frameInfo.blockSizeID = LZ4F_max4MB;
  preferences.compressionLevel = level;
  Bytes out(LZ4F_compressFrameBound(bytes.size(), &preferences));
  const std::size_t size =
      LZ4F_compressFrame(out.data(), out.size(), bytes.data(), bytes.size(), &preferences);
  if (LZ4F_isError(size) != 0U) {
    throw Error(std::string("lz4 cannot compress a chunk: ") + LZ4F_getErrorName(size));
  }
  out.resize(size);
  return out;
}

struct FreeLz4 {
  void operator()(LZ4F_dctx* context) const { LZ4F_freeDecompressionContext(context); }
};
using Lz4Context = std::unique_ptr<LZ4F_dctx, FreeLz4>;

Lz4Context make_lz4_context() {
  LZ4F_dctx* context = nullptr;
  const auto code = LZ4F_createDecompressionContext(&context, LZ4F_VERSION);
  if (LZ4F_isError(code) != 0U) {
    throw Error(std::string("lz4 cannot start: ") + LZ4F_getErrorName(code));
  }
  return Lz4Context(context);
}

std::size_t checked_lz4(std::size_t code) {
  if (LZ4F_isError(code) != 0U) {
    throw FormatError(std::string("damaged lz4 chunk: ") + LZ4F_getErrorName(code));
  }
  return code;
}

Bytes decompress_lz4(std::size_t size, ByteView bytes) {
  const Lz4Context context = make_lz4_context();
  // Before anything is allocated, as above.
  LZ4F_frameInfo_t frame{};
  std::size_t used = bytes.size();
  std::size_t wanted = checked_lz4(LZ4F_getFrameInfo(context.get(), &frame, bytes.data(), &used));
  if (frame.contentSize != 0 && frame.contentSize != size) {
    throw FormatError("a lz4 chunk does not have the size it claims");
  }
  Bytes out(size);
  std::size_t written = 0;
  // Each call takes in bytes or gives some out, until neither is possible: the frame is whole, cut
  // off, or longer than it claims.
  for (bool moves = true; wanted != 0 && moves;) {
    std::size_t taken = bytes.size() - used;
    std::size_t given = out.size() - written;
    wanted = checked_lz4(LZ4F_decompress(context.get(), out.data() + written, &given,
                                         bytes.data() + used, &taken, nullptr));
    used += taken;
    written += given;
    moves = taken + given > 0;
  }
  if (wanted != 0 || written != size) {
    throw FormatError("a lz4 chunk does not have the size it claims");
  }
  return out;
}

Bytes copy_uncompressed(std::size_t size, ByteView bytes) {
  if (bytes.size() != size) {
    throw FormatError("an uncompressed chunk does not have the size it claims");
  }
  return copy_of(bytes);
}

}  // namespace

std::string name_of(Compression compression) {
  switch (compression) {
    case Compression::kNone:
      return "";
    case Compression::kLz4:
      return "lz4";
    case Compression::kZstd:
      return "zstd";
  }
  return "";
}

Bytes compress(Compression compression, int level, ByteView bytes) {
  switch (compression) {
    case Compression::kNone:
      break;
    case Compression::kLz4:
      return compress_lz4(level, bytes);
    case Compression::kZstd:
      return compress_zstd(level, bytes);
  }
  return copy_of(bytes);
}

Bytes decompress(const std::string& method, std::uint64_t size, ByteView bytes) {
  if (size > kLargestChunk) {
    throw FormatError("a chunk claims " + std::to_string(size) + " bytes, more than 1 GiB");
  }
  const auto out_size = static_cast<std::size_t>(size);
  if (method.empty()) return copy_uncompressed(out_size, bytes);
  if (method == "lz4") return decompress_lz4(out_size, bytes);
  if (method == "zstd") return decompress_zstd(out_size, bytes);
  throw FormatError("chunk compression \"" + method +
                    "\" is not supported (zstd, lz4 and none are)");
}

}  // namespace scarab::mcap
