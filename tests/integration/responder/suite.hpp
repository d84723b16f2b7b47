#pragma once

#include <gmock/gmock.h>

#include <csignal>

#include "tests/integration/responder/stand_ins.hpp"
#include "tests/support/files.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/status_watch.hpp"

/// What holds for every stateful service of the chain, whichever questions it answers.
namespace scarab::test {

template <class Service>
class Responder : public testing::Test {
 protected:
  ChildProcess start_service(std::uint32_t instance = 0,
                             const std::string& expect = Service::kExpect) {
    return start({Service::kName, expect, run_dir_.path(), instance, {}});
  }
  /// Starts it and waits until it is ready for the trial.
  ChildProcess start_ready(std::uint32_t trial, std::uint32_t instance = 0) {
    auto child = start_service(instance);
    EXPECT_TRUE(status_.await_ready({Service::kName, instance}, trial, child.pid())) << child.err();
    return child;
  }
  /// The bytes of its answers to ticks 0..last if nothing disturbs it.
  std::vector<sample::Bytes> undisturbed(std::uint32_t trial, std::uint32_t last) {
    const TemporaryDirectory run_dir;
    auto child = start({Service::kName, Service::kExpect, run_dir.path(), 0, {}});
    stand_ins_.tell_trial(trial);
    EXPECT_TRUE(status_.await_ready(self_, trial)) << child.err();
    auto bytes = stand_ins_.consult_all(trial, 0, last);
    child.stop();
    return bytes;
  }

  const bus::Peer self_{Service::kName, 0};
  TemporaryDirectory run_dir_;
  StatusWatch status_;
  StandIns<Service> stand_ins_;
};

TYPED_TEST_SUITE_P(Responder);

TYPED_TEST_P(Responder, AnswersEachQuestionOnce) {
  constexpr std::uint32_t kLast = 40;
  this->stand_ins_.tell_trial(1);
  auto child = this->start_ready(1);
  ASSERT_EQ(this->stand_ins_.consult_all(1, 0, kLast).size(), kLast + 1) << child.err();
  EXPECT_EQ(child.stop(), 0);  // whatever it wrote has arrived now
  const auto& answers = this->stand_ins_.answers().all();
  ASSERT_EQ(answers.size(), kLast + 1);
  for (std::uint32_t tick = 0; tick <= kLast; ++tick) {
    const scarab_Header asked = TypeParam::question_of(1, tick).header;
    EXPECT_EQ(answers[tick].header.trial, asked.trial);
    EXPECT_EQ(answers[tick].header.tick, asked.tick);
    EXPECT_EQ(answers[tick].header.sim_time_ns, asked.sim_time_ns);
    EXPECT_GT(answers[tick].header.stamp_ns, 0);
  }
}

TYPED_TEST_P(Responder, RepeatedQuestionGetsTheSameAnswerAgain) {
  auto& stand_ins = this->stand_ins_;
  stand_ins.tell_trial(1);
  const auto child = this->start_ready(1);
  const auto first = stand_ins.consult_all(1, 0, 9);
  ASSERT_EQ(first.size(), 10U) << child.err();
  stand_ins.ask(1, 9);
  ASSERT_TRUE(eventually([&] { return stand_ins.answers().count(1, 9) == 2; })) << child.err();
  EXPECT_EQ(timeless_bytes(stand_ins.answers().all().back()), first.back());
  EXPECT_TRUE(stand_ins.consult(1, 10));  // and it goes on
}

TYPED_TEST_P(Responder, SkippedTickIsAFault) {
  auto& stand_ins = this->stand_ins_;
  stand_ins.tell_trial(1);
  const auto child = this->start_ready(1);
  ASSERT_EQ(stand_ins.consult_all(1, 0, 3).size(), 4U) << child.err();
  stand_ins.ask(1, 7);
  const auto report = this->status_.await_health(this->self_, scarab_HEALTH_FAULT);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->message, "cannot answer tick 7: last state is of tick 3");
  EXPECT_EQ(stand_ins.answers().count(1, 7), 0U);
}

/// In real time nobody repeats a question: the answer comes at once, from a state whose time has
/// gone on.
TYPED_TEST_P(Responder, InRealTimeItCatchesUpThroughMissedTicks) {
  auto& stand_ins = this->stand_ins_;
  const auto ask_in_real_time = [&](std::uint32_t tick) {
    auto question = TypeParam::question_of(1, tick);
    question.real_time = true;
    stand_ins.ask(question);
    return stand_ins.answers().await(1, tick);
  };
  stand_ins.tell_trial(1);
  {
    auto child = this->start_ready(1);
    for (std::uint32_t tick = 0; tick <= 3; ++tick) ASSERT_TRUE(ask_in_real_time(tick));
    child.kill();
  }
  const auto child = this->start_ready(1);
  const auto asked = std::chrono::steady_clock::now();
  ASSERT_TRUE(ask_in_real_time(9)) << child.err();
  EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::milliseconds(900))
      << "it waited for questions that cannot come";
  ASSERT_TRUE(ask_in_real_time(10));
  const auto report = this->status_.await(
      this->self_, [](const auto& r) { return r.counters.count("ticks_missed") == 1; });
  ASSERT_TRUE(report);
  EXPECT_EQ(report->counters.at("ticks_missed"), 5U);
  EXPECT_EQ(report->message, "caught up at tick 9 after 5 missed ticks");
  EXPECT_EQ(report->health, scarab_HEALTH_OK);
}

TYPED_TEST_P(Responder, KilledBetweenTicksItGoesOnBitByBit) {
  auto& stand_ins = this->stand_ins_;
  constexpr std::uint32_t kLast = 45;
  const auto wanted = this->undisturbed(1, kLast);
  ASSERT_EQ(wanted.size(), kLast + 1);
  // The same questions again under another number: answers differ in that number alone.
  constexpr std::uint32_t kTrial = 2;
  stand_ins.tell_trial(kTrial);
  std::uint32_t tick = 0;
  for (const std::uint32_t killed_after : {0U, 7U, 8U, 30U, kLast}) {
    auto child = this->start_ready(kTrial);
    for (; tick <= killed_after; ++tick) {
      auto answer = stand_ins.consult(kTrial, tick);
      ASSERT_TRUE(answer) << "tick " << tick << ": " << child.err();
      answer->header.trial = 1;
      ASSERT_EQ(timeless_bytes(*answer), wanted[tick]) << "tick " << tick;
    }
    child.kill();
  }
}

TYPED_TEST_P(Responder, KilledBeforeItAnswersItAnswersOnceRestarted) {
  auto& stand_ins = this->stand_ins_;
  const auto wanted = this->undisturbed(1, 11);
  stand_ins.tell_trial(2);
  {
    auto child = this->start_ready(2);
    ASSERT_EQ(stand_ins.consult_all(2, 0, 10).size(), 11U) << child.err();
    child.signal(SIGSTOP);
    stand_ins.ask(2, 11);
    child.kill();
  }
  EXPECT_EQ(stand_ins.answers().count(2, 11), 0U);
  const auto child = this->start_service();
  auto answer = stand_ins.answers().await(2, 11);
  ASSERT_TRUE(answer) << child.err();
  answer->header.trial = 1;
  EXPECT_EQ(timeless_bytes(*answer), wanted.at(11));
}

TYPED_TEST_P(Responder, QuestionsOfAnOldTrialAreDropped) {
  auto& stand_ins = this->stand_ins_;
  stand_ins.tell_trial(2);
  const auto child = this->start_ready(2);
  stand_ins.ask(1, 0);
  ASSERT_TRUE(stand_ins.consult(2, 0)) << child.err();
  EXPECT_EQ(stand_ins.answers().count(1, 0), 0U);
}

TYPED_TEST_P(Responder, QuestionsOfATrialNotYetKnownAreHeld) {
  auto& stand_ins = this->stand_ins_;
  stand_ins.tell_trial(1);
  const auto child = this->start_ready(1);
  ASSERT_TRUE(stand_ins.consult(1, 0)) << child.err();
  stand_ins.ask(2, 0);
  EXPECT_FALSE(stand_ins.answers().await(2, 0, std::chrono::milliseconds(200)));
  stand_ins.tell_trial(2);
  EXPECT_TRUE(stand_ins.answers().await(2, 0));
}

TYPED_TEST_P(Responder, StateOfAnEarlierTrialIsNotTakenUp) {
  auto& stand_ins = this->stand_ins_;
  const auto wanted = this->undisturbed(1, 3);
  stand_ins.tell_trial(2);
  {
    auto child = this->start_ready(2);
    ASSERT_EQ(stand_ins.consult_all(2, 0, 20).size(), 21U) << child.err();
    child.kill();
  }
  stand_ins.tell_trial(3);
  const auto child = this->start_ready(3);
  for (std::uint32_t tick = 0; tick <= 3; ++tick) {
    auto answer = stand_ins.consult(3, tick);
    ASSERT_TRUE(answer) << child.err();
    answer->header.trial = 1;
    EXPECT_EQ(timeless_bytes(*answer), wanted.at(tick));
  }
}

/// Whatever came over the bus while it was away is gone, but the other one keeps what it answers
/// by.
TYPED_TEST_P(Responder, RestartedReplicaTakesOverFromTheLivingOne) {
  auto& stand_ins = this->stand_ins_;
  constexpr std::uint32_t kLast = 30;
  const auto wanted = this->undisturbed(1, kLast);
  const std::string expect = std::string(TypeParam::kExpect) + "," + TypeParam::kName + "=2";
  const auto start_replica = [&](std::uint32_t instance) {
    auto child = this->start_service(instance, expect);
    EXPECT_TRUE(this->status_.await_ready({TypeParam::kName, instance}, 2, child.pid()))
        << child.err();
    return child;
  };
  // The first answer to each, and how many there are.
  const auto expect_answers = [&](std::uint32_t first, std::uint32_t last, std::size_t count) {
    for (std::uint32_t tick = first; tick <= last; ++tick) {
      auto answer = stand_ins.consult(2, tick);
      ASSERT_TRUE(answer) << "tick " << tick;
      answer->header.trial = 1;
      ASSERT_EQ(timeless_bytes(*answer), wanted.at(tick)) << "tick " << tick;
      ASSERT_TRUE(eventually([&] { return stand_ins.answers().count(2, tick) == count; }))
          << "tick " << tick;
    }
  };
  stand_ins.tell_trial(2);
  auto first = start_replica(0);
  {
    auto second = start_replica(1);
    expect_answers(0, 5, 2);
    second.kill();
  }
  expect_answers(6, 20, 1);
  const auto second = start_replica(1);
  expect_answers(21, 25, 2);
  first.kill();
  expect_answers(26, kLast, 1);
  const auto report = this->status_.await({TypeParam::kName, 1}, [](const auto&) { return true; });
  ASSERT_TRUE(report);
  EXPECT_EQ(report->health, scarab_HEALTH_OK) << report->message;
}

TYPED_TEST_P(Responder, SaysForWhomItWaits) {
  const std::string expect = std::string(TypeParam::kExpect) + ",logger=1";
  this->stand_ins_.tell_trial(1);
  auto child = this->start_service(0, expect);
  const std::string wanted = std::string("waits for logger/0 to read ") + TypeParam::answer().name;
  ASSERT_TRUE(this->status_.await_message(this->self_, wanted)) << child.err();
  EXPECT_EQ(child.stop(), 0);
  EXPECT_THAT(child.err(), testing::HasSubstr(wanted));
}

TYPED_TEST_P(Responder, EndsCleanlyOnSignals) {
  for (const int number : {SIGINT, SIGTERM}) {
    auto child = this->start_service();
    ASSERT_TRUE(this->status_.await(this->self_, [&](const auto& report) {
      return report.process_id == static_cast<std::uint32_t>(child.pid());
    }));
    child.signal(number);
    EXPECT_EQ(child.wait(kPatience), 0) << child.err();
    EXPECT_TRUE(this->status_.await_gone(this->self_));
  }
}

REGISTER_TYPED_TEST_SUITE_P(
    Responder, AnswersEachQuestionOnce, RepeatedQuestionGetsTheSameAnswerAgain, SkippedTickIsAFault,
    InRealTimeItCatchesUpThroughMissedTicks, KilledBetweenTicksItGoesOnBitByBit,
    KilledBeforeItAnswersItAnswersOnceRestarted, QuestionsOfAnOldTrialAreDropped,
    QuestionsOfATrialNotYetKnownAreHeld, StateOfAnEarlierTrialIsNotTakenUp,
    RestartedReplicaTakesOverFromTheLivingOne, SaysForWhomItWaits, EndsCleanlyOnSignals);

}  // namespace scarab::test
