#include <gmock/gmock.h>

#include "tests/integration/premotor/premotor_questions.hpp"
#include "tests/integration/responder/stand_ins.hpp"
#include "tests/support/files.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/status_watch.hpp"

namespace scarab::test {
namespace {

class PremotorReplica : public testing::Test {
 protected:
  ChildProcess start_ready(std::uint32_t instance) {
    auto child = start({"premotor", Premotor::kExpect, run_dir_.path(), instance, {}});
    EXPECT_TRUE(status_.await_ready({"premotor", instance}, 1)) << child.err();
    return child;
  }
  /// Both have answered, and equally.
  void expect_equal_answers(std::uint32_t tick) {
    ASSERT_TRUE(eventually([&] { return stand_ins_.answers().count(1, tick) == 2; }))
        << "tick " << tick;
    std::vector<sample::Bytes> bytes;
    for (const auto& answer : stand_ins_.answers().all()) {
      if (answer.header.tick == tick) bytes.push_back(timeless_bytes(answer));
    }
    EXPECT_EQ(bytes.at(0), bytes.at(1)) << "tick " << tick;
  }

  TemporaryDirectory run_dir_;
  StatusWatch status_;
  StandIns<Premotor> stand_ins_;
};

TEST_F(PremotorReplica, OneThatIsThereFromTheStartGivesEqualAnswers) {
  stand_ins_.tell_trial(1);
  const auto first = start_ready(0);
  const auto second = start_ready(1);
  for (std::uint32_t tick = 0; tick < 20; ++tick) {
    stand_ins_.ask(1, tick);
    expect_equal_answers(tick);
  }
}

TEST_F(PremotorReplica, OneThatStartsLateTakesOverTheLivingOnesState) {
  stand_ins_.tell_trial(1);
  auto first = start_ready(0);
  ASSERT_EQ(stand_ins_.consult_all(1, 0, 24).size(), 25U) << first.err();
  auto second = start_ready(1);
  for (std::uint32_t tick = 25; tick < 40; ++tick) {
    stand_ins_.ask(1, tick);
    expect_equal_answers(tick);
  }
  const auto report = status_.await({"premotor", 1}, [](const auto&) { return true; });
  ASSERT_TRUE(report);
  EXPECT_EQ(report->health, scarab_HEALTH_OK) << report->message;
  first.kill();
  EXPECT_EQ(stand_ins_.consult_all(1, 40, 50).size(), 11U) << second.err();
}

/// The state that neural_activity carries is the one the command was made from.
TEST_F(PremotorReplica, ActivityComesWithEveryCommand) {
  bus::Participant view(test_options("view"));
  Inbox<scarab_NeuralActivity> activities(view, bus::kNeuralActivity);
  stand_ins_.tell_trial(1);
  auto child = start_ready(0);
  ASSERT_TRUE(eventually([&] { return !activities.matched().empty(); }));
  ASSERT_EQ(stand_ins_.consult_all(1, 0, 20).size(), 21U) << child.err();
  EXPECT_EQ(child.stop(), 0);
  ASSERT_EQ(activities.all().size(), 21U);
  for (std::uint32_t tick = 0; tick <= 20; ++tick) {
    EXPECT_EQ(activities.all()[tick].header.tick, tick);
  }
}

}  // namespace
}  // namespace scarab::test
