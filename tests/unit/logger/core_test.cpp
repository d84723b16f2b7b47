/// The recorder's pure parts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/bus/cdr.hpp"
#include "common/bus/topics.hpp"
#include "services/logger/core/base64.hpp"
#include "services/logger/core/chain_writers.hpp"
#include "services/logger/core/disk_guard.hpp"
#include "services/logger/core/recorded_progress.hpp"
#include "services/logger/core/sample_header.hpp"
#include "services/logger/core/state_flags.hpp"

namespace scarab::logger {
namespace {

TEST(SampleHeader, IsWhatTheBusEncodes) {
  scarab_Behaviour behaviour{};
  behaviour.header = {7, 4'000'000'000U, -5, 1'700'000'000'123'456'789LL};
  const sample::Bytes bytes = bus::encode(behaviour);
  const auto header =
      read_sample_header(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  ASSERT_TRUE(header.has_value());
  EXPECT_EQ(header->trial, 7U);
  EXPECT_EQ(header->tick, 4'000'000'000U);
  EXPECT_EQ(header->sim_time_ns, -5);
  EXPECT_EQ(header->stamp_ns, 1'700'000'000'123'456'789LL);
}

TEST(SampleHeader, TheStampIsTheOnlyThingInItsPlace) {
  scarab_RobotState a{};
  scarab_RobotState b{};
  b.header.stamp_ns = -1;
  const sample::Bytes bytes_a = bus::encode(a);
  const sample::Bytes bytes_b = bus::encode(b);
  for (std::size_t i = 0; i < bytes_a.size(); ++i) {
    EXPECT_EQ(bytes_a[i] != bytes_b[i], i >= kStampBegin && i < kStampEnd) << "byte " << i;
  }
}

TEST(SampleHeader, OfBothByteOrders) {
  std::uint8_t bytes[28] = {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0};  // big-endian: trial 1, tick 256
  EXPECT_EQ(read_sample_header(bytes, sizeof(bytes))->tick, 256U);
  bytes[1] = 1;  // the same bytes read as little-endian
  EXPECT_EQ(read_sample_header(bytes, sizeof(bytes))->trial, 1U << 24U);
  bytes[1] = 2;  // a parameter list, no plain CDR
  EXPECT_FALSE(read_sample_header(bytes, sizeof(bytes)).has_value());
  bytes[1] = 1;
  EXPECT_FALSE(read_sample_header(bytes, sizeof(bytes) - 1).has_value());
}

SampleHeader at(std::uint32_t trial, std::uint32_t tick) { return {trial, tick, 0, 0}; }

TEST(RecordedProgress, FollowsTheTicksOfATrial) {
  RecordedProgress progress;
  for (std::uint32_t tick = 0; tick < 5; ++tick) progress.note(at(1, tick));
  EXPECT_EQ(progress.trial(), 1U);
  EXPECT_EQ(progress.tick(), 4U);
  EXPECT_EQ(progress.missed_ticks(), 0U);
  progress.note(at(2, 0));
  EXPECT_EQ(progress.trial(), 2U);
  EXPECT_EQ(progress.tick(), 0U);
  EXPECT_EQ(progress.trials(), 2U);
}

TEST(RecordedProgress, RepetitionsAndOldTrialsChangeNothing) {
  RecordedProgress progress;
  progress.note(at(2, 3));
  progress.note(at(2, 3));
  progress.note(at(2, 1));
  progress.note(at(1, 9));
  EXPECT_EQ(progress.trial(), 2U);
  EXPECT_EQ(progress.tick(), 3U);
  EXPECT_EQ(progress.missed_ticks(), 0U);
}

TEST(RecordedProgress, CountsGapsButGoesOn) {
  RecordedProgress progress;
  progress.note(at(1, 40));  // restarted in the middle: no gap
  progress.note(at(1, 43));
  EXPECT_EQ(progress.tick(), 43U);
  EXPECT_EQ(progress.missed_ticks(), 2U);
}

TEST(StateFlags, AreWhatTheBusEncodes) {
  const auto flags_of = [](scarab_TrialPhase phase, bool real_time) {
    scarab_RobotState state{};
    state.phase = phase;
    state.real_time = real_time;
    const sample::Bytes bytes = bus::encode(state);
    return *read_state_flags(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  };
  EXPECT_FALSE(flags_of(scarab_PHASE_RUNNING, false).real_time);
  EXPECT_TRUE(flags_of(scarab_PHASE_RUNNING, true).real_time);
  for (const auto phase : {scarab_PHASE_RUNNING, scarab_PHASE_SAFE_STOP, scarab_PHASE_HOMING}) {
    EXPECT_FALSE(flags_of(phase, false).over) << phase;
  }
  EXPECT_TRUE(flags_of(scarab_PHASE_SUCCEEDED, false).over);
  EXPECT_TRUE(flags_of(scarab_PHASE_FAILED, true).over);
}

TEST(StateFlags, OfBothByteOrdersAndOfEnoughBytes) {
  std::uint8_t bytes[33] = {0, 0};  // big-endian
  bytes[31] = 4;                    // phase
  bytes[32] = 1;
  EXPECT_TRUE(read_state_flags(bytes, sizeof(bytes))->over);
  EXPECT_TRUE(read_state_flags(bytes, sizeof(bytes))->real_time);
  EXPECT_FALSE(read_state_flags(bytes, sizeof(bytes) - 1).has_value());
  bytes[1] = 3;  // a parameter list
  EXPECT_FALSE(read_state_flags(bytes, sizeof(bytes)).has_value());
}

TEST(DiskGuard, KeepsTheLimitFreeAndBeginsAgainOnlyWithMore) {
  DiskGuard guard(80);
  guard.update(80, 0);
  EXPECT_TRUE(guard.has_room());
  guard.update(85, 6);
  EXPECT_FALSE(guard.has_room()) << "what waits counts";
  guard.update(89, 0);
  EXPECT_FALSE(guard.has_room());
  guard.update(90, 0);
  EXPECT_TRUE(guard.has_room());
  DiskGuard without(0);
  without.update(0, 1000);
  EXPECT_TRUE(without.has_room());
}

TEST(Base64, IsThatOfTheStandard) {
  const auto text = [](const std::string& bytes) {
    return base64(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  };
  // RFC 4648, section 10.
  EXPECT_EQ(text(""), "");
  EXPECT_EQ(text("f"), "Zg==");
  EXPECT_EQ(text("fo"), "Zm8=");
  EXPECT_EQ(text("foo"), "Zm9v");
  EXPECT_EQ(text("foob"), "Zm9vYg==");
  EXPECT_EQ(text("fooba"), "Zm9vYmE=");
  EXPECT_EQ(text("foobar"), "Zm9vYmFy");
  EXPECT_EQ(text("\xFB\xFF\xFE"), "+//+");
}

TEST(ChainWriters, AreThoseOfTheExpectedServices) {
  const auto writers =
      chain_writers({{"plant", 1}, {"premotor", 2}, {"logger", 1}, {"stranger", 1}});
  std::vector<std::string> topics;
  for (const ChainWriter& writer : writers) {
    topics.push_back(writer.topic);
    EXPECT_EQ(writer.count, writer.service == "premotor" ? 2U : 1U);
  }
  EXPECT_THAT(topics, testing::UnorderedElementsAre("scarab/robot_state", "scarab/robot_sensors",
                                                    "scarab/world_state", "scarab/joint_command",
                                                    "scarab/neural_activity"));
  EXPECT_TRUE(chain_writers({{"supervisor", 0}}).empty());
}

}  // namespace
}  // namespace scarab::logger
