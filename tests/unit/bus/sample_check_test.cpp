#include "common/bus/sample_check.hpp"

#include <gmock/gmock.h>

#include <cstring>

#include "common/bus/cdr.hpp"
#include "common/bus/error.hpp"
#include "common/bus/sample_fields.hpp"

namespace scarab::bus {
namespace {

using testing::StrEq;
using testing::ThrowsMessage;

template <class T>
void expect_refused(const T& sample, const char* why) {
  const SampleCheck check(descriptor<T>());
  EXPECT_THAT([&] { check.check(&sample); }, ThrowsMessage<Error>(StrEq(why)));
}

TEST(SampleCheck, AcceptsZeroes) {
  const scarab_WorldState sample{};
  EXPECT_NO_THROW(SampleCheck(descriptor<scarab_WorldState>()).check(&sample));
}

TEST(SampleCheck, NamesABadEnumValue) {
  scarab_RobotState sample{};
  std::memset(&sample.torque_source[18], 0x7F, sizeof(sample.torque_source[18]));
  expect_refused(sample, "torque_source[18]: 2139062143 is no scarab::Source");
}

TEST(SampleCheck, NamesATextWithoutEnd) {
  scarab_Behaviour sample{};
  std::memset(sample.reason, 'x', sizeof(sample.reason));
  expect_refused(sample, "reason: text without end");
}

TEST(SampleCheck, NamesASequenceBeyondItsBound) {
  std::vector<scarab_Contact> contacts(97);
  scarab_WorldState sample{};
  borrow(sample.contacts, contacts);
  expect_refused(sample, "contacts: 97 elements, at most 96");
}

TEST(SampleCheck, LooksIntoSequences) {
  std::vector<scarab_Counter> counters(3);
  std::memset(counters[2].name, 'x', sizeof(counters[2].name));
  scarab_ServiceStatus sample{};
  borrow(sample.counters, counters);
  expect_refused(sample, "counters[2].name: text without end");
}

TEST(SampleCheck, PaddingBecomesZeroAndValuesStay) {
  const SampleCheck check(descriptor<scarab_JointCommand>());
  scarab_JointCommand sample;
  std::memset(&sample, 0xAA, sizeof(sample));
  sample.kind = scarab_COMMAND_POSITION;
  std::vector<std::byte> buffer;
  const void* clean = check.without_padding(&sample, buffer);
  scarab_JointCommand expected;
  std::memset(&expected, 0, sizeof(expected));
  expected.header = sample.header;
  expected.kind = sample.kind;
  std::memcpy(expected.position_rad, sample.position_rad, sizeof(expected.position_rad));
  EXPECT_EQ(std::memcmp(clean, &expected, sizeof(expected)), 0);
}

TEST(SampleCheck, ATypeWithoutPaddingIsNotCopied) {
  const SampleCheck check(descriptor<scarab_NeuralActivity>());
  const scarab_NeuralActivity sample{};
  std::vector<std::byte> buffer;
  EXPECT_EQ(check.without_padding(&sample, buffer), &sample);
}

}  // namespace
}  // namespace scarab::bus
