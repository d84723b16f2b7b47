#include "common/config/scalar.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "common/config/range.hpp"
#include "common/random/random.hpp"

namespace scarab::config {
namespace {

TEST(ParseNumber, TakesDecimalNotationOnly) {
  for (const char* text : {"0", "-0", "1", "+1", "1.", ".5", "+.5", "-1.5e-3", "1E5", "0.1"}) {
    EXPECT_TRUE(parse_number(text).value) << text;
  }
  for (const char* text :
       {"",       "+",   "-",         ".",     "e5",   "1e",  "0x1", "1_000", "1,5",
        " 1",     "1 ",  "1.2.3",     "--1",   "+-1",  "00",  "-01", "nan",   "NAN",
        "nan(1)", "inf", "+Infinity", "1e400", "true", "0b1", "0o7", "1m"}) {
    EXPECT_FALSE(parse_number(text).value) << text;
    EXPECT_FALSE(parse_number(text).reason.empty()) << text;
  }
}

TEST(ParseWhole, TakesTheWholeRangeOfTheTypeAndNoMore) {
  EXPECT_EQ(parse_signed("-9223372036854775808").value, std::numeric_limits<long long>::min());
  EXPECT_EQ(parse_unsigned("18446744073709551615").value,
            std::numeric_limits<unsigned long long>::max());
  EXPECT_FALSE(parse_signed("9223372036854775808").value);
  EXPECT_FALSE(parse_unsigned("18446744073709551616").value);
  EXPECT_FALSE(parse_unsigned("-1").value);
  EXPECT_EQ(parse_unsigned("-0").value, std::nullopt);
  EXPECT_FALSE(parse_signed("1.0").value);
  EXPECT_FALSE(parse_signed("1e3").value);
}

TEST(FormatNumber, ReadsBackToTheSameBits) {
  constexpr auto kStream = random::stream("doubles");
  int finite = 0;
  for (std::uint64_t i = 0; i < 100'000; ++i) {
    const std::uint64_t bits = random::bits(1, kStream, i);
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    ++finite;
    const auto parsed = parse_number(format_number(value));
    ASSERT_TRUE(parsed.value) << format_number(value) << ": " << parsed.reason;
    ASSERT_EQ(std::memcmp(&*parsed.value, &value, sizeof value), 0) << format_number(value);
  }
  EXPECT_GT(finite, 90'000);
}

TEST(FormatNumber, IsTheShortest) {
  EXPECT_EQ(format_number(0.1), "0.1");
  EXPECT_EQ(format_number(1.0 / 3.0), "0.3333333333333333");
  EXPECT_EQ(format_number(100), "100");
  EXPECT_EQ(format_number(-0.0), "-0");
}

TEST(Range, IsDescribedInWords) {
  EXPECT_EQ(describe(kPositive), "above 0");
  EXPECT_EQ(describe(kNonNegative), "at least 0");
  EXPECT_EQ(describe(kFraction), "in [0, 1]");
  EXPECT_EQ(describe(Range{0, 1, true}), "in (0, 1]");
  EXPECT_EQ(describe(Range{kAny.min, 3}), "at most 3");
}

TEST(Range, HasItsEnds) {
  EXPECT_TRUE(kFraction.contains(0));
  EXPECT_TRUE(kFraction.contains(1));
  EXPECT_FALSE(kPositive.contains(0));
  EXPECT_FALSE(kAny.contains(std::nan("")));
}

}  // namespace
}  // namespace scarab::config
