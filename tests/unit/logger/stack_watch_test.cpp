/// What the recorder makes of samples on their way: when it may drop, and what was dropped.
#include "services/logger/stack_watch.hpp"

#include <gtest/gtest.h>

#include "common/bus/cdr.hpp"
#include "common/bus/topics.hpp"
#include "services/logger/loss_account.hpp"

namespace scarab::logger {
namespace {

using namespace std::chrono_literals;
using Clock = StackWatch::Clock;

enum Channel : std::uint32_t { kState, kTrialChannel, kForeign };

SampleBatch with_channels() {
  SampleBatch batch;
  batch.add_channel({"scarab/robot_state", "scarab::RobotState", "", TopicRole::kProgress, {}});
  batch.add_channel({"scarab/trial", "scarab::Trial", "", TopicRole::kTrial, {}});
  batch.add_channel({"foreign", "Foreign", "", TopicRole::kNone, {}});
  return batch;
}

void add(SampleBatch& batch, Channel channel, const sample::Bytes& bytes) {
  SampleBatch::Entry entry;
  entry.channel = channel;
  batch.add(entry, {bytes.data(), bytes.size()});
}

class Watch : public testing::Test {
 protected:
  Watch() { watch_.note(with_channels(), now_); }

  void announce(std::uint32_t number) {
    scarab_Trial trial{};
    trial.header.trial = number;
    SampleBatch batch;
    add(batch, kTrialChannel, bus::encode(trial));
    watch_.note(batch, now_);
  }
  void state(std::uint32_t trial, bool real_time, scarab_TrialPhase phase = scarab_PHASE_RUNNING) {
    scarab_RobotState state{};
    state.header.trial = trial;
    state.real_time = real_time;
    state.phase = phase;
    SampleBatch batch;
    add(batch, kState, bus::encode(state));
    watch_.note(batch, now_);
  }

  Clock::time_point now_ = Clock::now();
  StackWatch watch_;
};

TEST_F(Watch, NobodyWaitsBeforeATrialRuns) {
  EXPECT_FALSE(watch_.in_lockstep(now_));
  announce(1);
  EXPECT_EQ(watch_.trial(), 1U);
  EXPECT_FALSE(watch_.in_lockstep(now_));
}

TEST_F(Watch, TheNewestStateOfTheRunningTrialSaysWhetherTheStackWaits) {
  announce(1);
  state(1, false);
  EXPECT_TRUE(watch_.in_lockstep(now_));
  state(1, true);
  EXPECT_FALSE(watch_.in_lockstep(now_));
  state(1, false);
  announce(2);
  EXPECT_FALSE(watch_.in_lockstep(now_)) << "that was trial 1";
  state(2, false);
  EXPECT_TRUE(watch_.in_lockstep(now_));
}

TEST_F(Watch, AnswersToTheLastTickAreStillWaitedFor) {
  announce(1);
  state(1, false, scarab_PHASE_SUCCEEDED);
  EXPECT_TRUE(watch_.in_lockstep(now_ + 500ms));
  EXPECT_FALSE(watch_.in_lockstep(now_ + 2s));
}

TEST_F(Watch, BytesThatAreNoStateSayNothing) {
  announce(1);
  state(1, false);
  SampleBatch batch;
  add(batch, kState, sample::Bytes(3));
  add(batch, kTrialChannel, sample::Bytes(3));
  add(batch, kForeign, sample::Bytes(300));
  watch_.note(batch, now_);
  EXPECT_TRUE(watch_.in_lockstep(now_));
  EXPECT_EQ(watch_.role_of(kForeign), TopicRole::kNone);
}

TEST(SampleBatch, LetsGoOfSamplesAndCountsThem) {
  SampleBatch batch = with_channels();
  for (std::uint8_t i = 0; i < 9; ++i) {
    add(batch, static_cast<Channel>(i % 3), sample::Bytes(2 + i, std::byte{i}));
  }
  batch.drop_samples([](std::uint32_t channel) { return channel == kTrialChannel; });
  ASSERT_EQ(batch.entries().size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto number = static_cast<std::uint8_t>(3 * i + 1);
    EXPECT_EQ(mcap::copy_of(batch.bytes(batch.entries()[i])), mcap::Bytes(2U + number, number));
  }
  EXPECT_EQ(batch.losses().at(kState).dropped, 3U);
  EXPECT_EQ(batch.losses().count(kTrialChannel), 0U);

  LossAccount account;
  EXPECT_EQ(account.dropped_in_words(), "");
  account.note(batch);
  SampleBatch later;
  later.add_loss(kForeign, {2, 5});
  account.note(later);
  EXPECT_EQ(account.total().dropped, 8U);
  EXPECT_EQ(account.total().lost, 5U);
  EXPECT_EQ(account.dropped_in_words(),
            "8 samples dropped (foreign 5, scarab/robot_state 3): they came faster than they could "
            "be written");
}

}  // namespace
}  // namespace scarab::logger
