#include "common/bus/sample_fields.hpp"

#include <gtest/gtest.h>

#include "common/bus/topic.hpp"

namespace scarab::bus {
namespace {

TEST(SampleFields, AssignFitsExactlyOrThrows) {
  char field[4] = {'x', 'x', 'x', 'x'};
  assign(field, "abc");
  EXPECT_STREQ(field, "abc");
  assign(field, "");
  EXPECT_EQ(std::string(field, 4), std::string(4, '\0'));
  EXPECT_THROW(assign(field, "abcd"), Error);
}

TEST(SampleFields, TruncatingKeepsWholeCharacters) {
  char field[6];
  assign_truncated(field, "abcdefgh");
  EXPECT_STREQ(field, "abcde");
  assign_truncated(field, "abcd\u00e9f");  // the e with accent takes two bytes
  EXPECT_STREQ(field, "abcd");
  assign_truncated(field, "abc\u00e9");
  EXPECT_STREQ(field, "abc\u00e9");
}

TEST(SampleFields, TextOfAFieldWithoutEndStaysInside) {
  const char field[3] = {'a', 'b', 'c'};
  EXPECT_EQ(text(field), "abc");
}

TEST(SampleFields, BorrowedSequencesShowTheVector) {
  std::vector<scarab_Counter> counters(2);
  counters[1].value = 9;
  scarab_ServiceStatus status{};
  borrow(status.counters, counters);
  EXPECT_FALSE(status.counters._release);
  ASSERT_EQ(elements(status.counters).size(), 2U);
  EXPECT_EQ(elements(status.counters)[1].value, 9U);
}

}  // namespace
}  // namespace scarab::bus
