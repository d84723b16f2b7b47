#include "common/mcap/crc32.hpp"

#include <gtest/gtest.h>

#include <string_view>

namespace scarab::mcap {
namespace {

using namespace std::string_view_literals;

TEST(Crc32, HasThePublishedCheckValue) { EXPECT_EQ(crc32("123456789"sv), 0xCBF43926U); }

TEST(Crc32, OfNothingIsZero) { EXPECT_EQ(crc32(ByteView{}), 0U); }

TEST(Crc32, DoesNotDependOnHowTheBytesAreDivided) {
  Bytes bytes(100);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bytes[i] = static_cast<std::uint8_t>(i * 31);
  }
  for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
    Crc32 crc;
    crc.update(ByteView(bytes).slice(0, cut));
    crc.update(ByteView(bytes).slice(cut, bytes.size() - cut));
    EXPECT_EQ(crc.value(), crc32(bytes)) << "divided at " << cut;
  }
}

}  // namespace
}  // namespace scarab::mcap
