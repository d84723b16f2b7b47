#include "common/runtime/state_file.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cstring>
#include <system_error>

#include "tests/support/files.hpp"

namespace scarab::runtime {
namespace {

constexpr std::uint32_t kLayout = 7;

/// Odd in size, so that the slots have padding behind the payload.
struct Payload {
  std::array<std::uint8_t, 101> bytes{};
};

Payload payload_of(std::int64_t tick) {
  Payload payload;
  for (std::size_t i = 0; i < payload.bytes.size(); ++i) {
    payload.bytes[i] = static_cast<std::uint8_t>(static_cast<std::size_t>(tick) * 31 + i * 7);
  }
  return payload;
}

class StateFileTest : public testing::Test {
 protected:
  using File = TypedStateFile<Payload>;

  void write_ticks(std::int64_t last) const {
    File file(path_, kLayout);
    for (std::int64_t tick = 0; tick <= last; ++tick) file.write({1, tick}, payload_of(tick));
  }

  /// The tick of the record that a restarted service finds; -1 if none. A record that is not what
  /// was written under its tick fails the test.
  std::int64_t found(std::uint32_t layout = kLayout) const {
    const File file(path_, layout);
    Payload payload;
    const auto key = file.read(payload);
    if (!key) return -1;
    EXPECT_EQ(key->trial, 1U);
    EXPECT_EQ(payload.bytes, payload_of(key->tick).bytes) << "tick " << key->tick;
    return key->tick;
  }

  test::TemporaryDirectory directory_;
  std::filesystem::path path_ = directory_ / "premotor-0.state";
};

TEST_F(StateFileTest, NewFileHoldsNothing) { EXPECT_EQ(found(), -1); }

TEST_F(StateFileTest, HoldsTheNewestRecordAndKeepsItWhenReopened) {
  File file(path_, kLayout);
  for (std::int64_t tick = 0; tick < 5; ++tick) {
    file.write({1, tick}, payload_of(tick));
    Payload payload;
    ASSERT_TRUE(file.read(payload));
    EXPECT_EQ(payload.bytes, payload_of(tick).bytes);
    EXPECT_EQ(found(), tick);
  }
}

TEST_F(StateFileTest, ReopenedFileGoesOnWithItsSequence) {
  for (std::int64_t tick = 0; tick < 5; ++tick) {
    {
      File file(path_, kLayout);
      file.write({1, tick}, payload_of(tick));
    }
    EXPECT_EQ(found(), tick);
  }
}

TEST_F(StateFileTest, ANewerRecordOfAnEarlierTickIsTheNewest) {
  write_ticks(9);
  File(path_, kLayout).write({1, 0}, payload_of(0));  // a new trial begins at 0 again
  EXPECT_EQ(found(), 0);
}

TEST_F(StateFileTest, AnotherLayoutIsNotRead) {
  write_ticks(3);
  EXPECT_EQ(found(kLayout + 1), -1);
}

TEST_F(StateFileTest, AnotherSizeIsNotRead) {
  write_ticks(3);
  const TypedStateFile<std::array<std::uint8_t, 300>> larger(path_, kLayout);
  std::array<std::uint8_t, 300> payload{};
  EXPECT_FALSE(larger.read(payload));
}

TEST_F(StateFileTest, PeekSeesTheNewestRecordAndChangesNothing) {
  write_ticks(3);
  const std::string before = test::read_text(path_);
  Payload payload;
  const auto key = File::peek(path_, kLayout, payload);
  ASSERT_TRUE(key);
  EXPECT_EQ(key->tick, 3);
  EXPECT_EQ(payload.bytes, payload_of(3).bytes);
  EXPECT_EQ(test::read_text(path_), before);
}

TEST_F(StateFileTest, PeekTakesNothingThatIsNotAlike) {
  Payload payload;
  EXPECT_FALSE(File::peek(path_, kLayout, payload));
  EXPECT_FALSE(std::filesystem::exists(path_)) << "made by looking";
  write_ticks(3);
  EXPECT_FALSE(File::peek(path_, kLayout + 1, payload));
  std::array<std::uint8_t, 300> larger{};
  EXPECT_FALSE((TypedStateFile<std::array<std::uint8_t, 300>>::peek(path_, kLayout, larger)));
  std::filesystem::resize_file(path_, std::filesystem::file_size(path_) + 1);
  EXPECT_FALSE(File::peek(path_, kLayout, payload));
}

/// At every byte: the part of the file before it is already new, the rest still old.
TEST_F(StateFileTest, RecordTornAtAnyByteIsNeverReturnedAsWhole) {
  write_ticks(4);
  const std::string before = test::read_text(path_);
  File(path_, kLayout).write({1, 5}, payload_of(5));
  const std::string after = test::read_text(path_);
  ASSERT_EQ(before.size(), after.size());
  std::size_t whole = 0;
  for (std::size_t torn = 0; torn <= before.size(); ++torn) {
    test::write_text(path_, after.substr(0, torn) + before.substr(torn));
    const auto tick = found();
    EXPECT_TRUE(tick == 4 || tick == 5) << "torn at byte " << torn;
    whole += tick == 5 ? 1 : 0;
  }
  EXPECT_GT(whole, 0U);
  EXPECT_LT(whole, before.size());
}

/// A byte gone bad costs at most the record it is in.
TEST_F(StateFileTest, DamageAnywhereLeavesTheOtherRecord) {
  write_ticks(5);
  const std::string sound = test::read_text(path_);
  std::size_t lost_newest = 0;
  for (std::size_t at = 0; at < sound.size(); ++at) {
    std::string damaged = sound;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    test::write_text(path_, damaged);
    const auto tick = found();
    EXPECT_TRUE(tick == 5 || tick == 4) << "byte " << at;
    lost_newest += tick == 4 ? 1 : 0;
  }
  EXPECT_GE(lost_newest, sizeof(Payload));  // none of the newest payload's bytes is unguarded
}

TEST_F(StateFileTest, FileThatIsNoStateFileIsBegunAnew) {
  test::write_text(path_, std::string(5000, 'x'));
  EXPECT_EQ(found(), -1);
  write_ticks(2);
  EXPECT_EQ(found(), 2);
}

TEST_F(StateFileTest, TruncatedFileIsBegunAnew) {
  write_ticks(2);
  std::filesystem::resize_file(path_, 10);
  EXPECT_EQ(found(), -1);
}

TEST_F(StateFileTest, ErrorNamesThePath) {
  const auto nowhere = directory_ / "no" / "such.state";
  try {
    const File file(nowhere, kLayout);
    FAIL() << "opened";
  } catch (const std::system_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(nowhere.string()));
  }
}

}  // namespace
}  // namespace scarab::runtime
