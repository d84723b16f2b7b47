#include "common/mcap/compression.hpp"

#include <gmock/gmock.h>

#include <numeric>
#include <random>

#include "common/mcap/error.hpp"

namespace scarab::mcap {
namespace {

/// Bytes without any pattern, of which no method makes fewer.
Bytes noise(std::size_t size) {
  std::mt19937 random(7);
  Bytes bytes(size);
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
  return bytes;
}

class CompressionTest : public testing::TestWithParam<Compression> {
 protected:
  static std::string method() { return name_of(GetParam()); }
  /// What decompress() says of bytes that are no chunk of `size` bytes.
  static std::string refusal(std::uint64_t size, ByteView bytes) {
    try {
      decompress(method(), size, bytes);
    } catch (const FormatError& error) {
      return error.what();
    }
    return "";
  }
};

TEST_P(CompressionTest, GivesBackWhatWentIn) {
  for (const std::size_t size : {0U, 1U, 1000U, 1U << 20U, (5U << 20U) + 3U}) {
    for (const Bytes& bytes : {Bytes(size, 7), noise(size)}) {
      const Bytes packed = compress(GetParam(), 1, bytes);
      EXPECT_EQ(decompress(method(), size, packed), bytes) << size << " bytes";
    }
  }
}

TEST_P(CompressionTest, MakesFewerBytesOfAPattern) {
  const Bytes packed = compress(GetParam(), 1, Bytes(100'000, 7));
  if (GetParam() == Compression::kNone) {
    EXPECT_EQ(packed.size(), 100'000U);
  } else {
    EXPECT_LT(packed.size(), 1000U);
  }
}

TEST_P(CompressionTest, TakesEveryLevelOfTheConfiguration) {
  const Bytes bytes = noise(3000);
  for (int level = 1; level <= 19; ++level) {
    EXPECT_EQ(decompress(method(), bytes.size(), compress(GetParam(), level, bytes)), bytes);
  }
}

TEST_P(CompressionTest, RefusesAnotherSizeThanItClaims) {
  const Bytes packed = compress(GetParam(), 1, noise(1000));
  EXPECT_NE(refusal(999, packed), "");
  EXPECT_NE(refusal(1001, packed), "");
  EXPECT_NE(refusal(0, packed), "");
}

TEST_P(CompressionTest, RefusesWhatIsCutOff) {
  const Bytes packed = compress(GetParam(), 1, noise(1000));
  for (std::size_t size = 0; size < packed.size(); ++size) {
    ASSERT_NE(refusal(1000, ByteView(packed).slice(0, size)), "") << size << " bytes";
  }
}

TEST_P(CompressionTest, RefusesAGigabyteBeforeItIsThere) {
  const Bytes packed = compress(GetParam(), 1, noise(10));
  EXPECT_THAT(refusal((std::uint64_t{1} << 30U) + 1, packed), testing::HasSubstr("1 GiB"));
}

INSTANTIATE_TEST_SUITE_P(Methods, CompressionTest,
                         testing::Values(Compression::kNone, Compression::kLz4, Compression::kZstd),
                         [](const auto& method) {
                           const std::string name = name_of(method.param);
                           return name.empty() ? std::string("none") : name;
                         });

TEST(CompressionNameTest, OtherMethodsAreNamedAndRefused) {
  try {
    decompress("brotli", 1, Bytes{1});
    FAIL() << "taken";
  } catch (const FormatError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("\"brotli\" is not supported"));
  }
}

/// The magic number of a frame (LZ4 frame format 1.6, Zstandard RFC 8878), which other readers of
/// MCAP look for.
TEST(CompressionNameTest, FramesAreThoseOfTheFormats) {
  const Bytes lz4 = compress(Compression::kLz4, 1, noise(100));
  EXPECT_EQ(Bytes(lz4.begin(), lz4.begin() + 4), (Bytes{0x04, 0x22, 0x4D, 0x18}));
  const Bytes zstd = compress(Compression::kZstd, 1, noise(100));
  EXPECT_EQ(Bytes(zstd.begin(), zstd.begin() + 4), (Bytes{0x28, 0xB5, 0x2F, 0xFD}));
}

}  // namespace
}  // namespace scarab::mcap
