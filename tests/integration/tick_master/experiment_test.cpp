#include "tests/integration/tick_master/fixture.hpp"
#include "tests/support/files.hpp"
#include "tests/support/programs.hpp"

/// scarab-experiment on a robot: its tick master says how a trial ends, and whoever sees the world,
/// if anybody does, is none of the stack.
namespace scarab::test {
namespace {

using testing::HasSubstr;

class Experiment : public MasterOfABody {
 protected:
  void conduct() {
    start({});
    conductor_.emplace(Arguments{program("scarab-experiment"), "--tag", test_tag(), "--expect",
                                 "robot_bridge=1,supervisor=1,premotor=1", "--time-limit", "1000"},
                       directory_ / "experiment");
    ASSERT_TRUE(eventually([&] { return body_->count(Call::kBegin) > 0; }));
    ends_.say_ready(1);
    expect_trial(1);
    ASSERT_TRUE(answer_until(0.1, [&] { return applied(0.1); })) << conductor_->output();
  }
  /// What it says at the end.
  std::string result() {
    EXPECT_TRUE(answer_until(0.1, [&] { return !conductor_->running(); }));
    return conductor_->output();
  }

  // Who is told the trial.
  bus::Participant supervisor_{test_options("supervisor")};
  bus::Participant premotor_{test_options("premotor")};
  bus::Reader<scarab_Trial> of_supervisor_{supervisor_, bus::kTrial};
  bus::Reader<scarab_Trial> of_premotor_{premotor_, bus::kTrial};
  TemporaryDirectory directory_;
  std::optional<ChildProcess> conductor_;
};

TEST_F(Experiment, EndsByTheTickMastersWordAndReason) {
  conduct();
  const auto said = RecordingBody::Clock::now();
  body_->change([](auto& fate) { fate.verdict = {true, "ran to the time limit"}; });
  EXPECT_THAT(result(), HasSubstr("result: success after"));
  EXPECT_LT(RecordingBody::Clock::now() - said, std::chrono::seconds(5)) << "nothing is awaited";
  EXPECT_THAT(conductor_->output(), HasSubstr("ran to the time limit"));
  EXPECT_EQ(conductor_->wait(kPatience), 0);
}

TEST_F(Experiment, TakesMeasuresAndReasonFromWhoSeesTheWorld) {
  bus::Participant tracker(test_options("tracker"));
  bus::Writer<scarab_WorldState> worlds(tracker, bus::kWorldState);
  conduct();
  ASSERT_TRUE(eventually([&] { return !worlds.matched().empty(); }));
  scarab_WorldState world{};
  world.header = {1, 700, 70'000'000'000, bus::now_ns()};  // its own ticks
  world.trunk.orientation_wxyz[0] = 1;
  world.object_travel_m = 0.5;
  world.verdict = scarab_VERDICT_FAILURE;
  bus::assign(world.verdict_reason, "the object rolled away");
  worlds.write(world);
  body_->change([](auto& fate) { fate.verdict = {false, "as the tracker says"}; });
  EXPECT_THAT(result(), HasSubstr("the object rolled away"));
  EXPECT_EQ(conductor_->wait(kPatience), 1);
}

/// Longer than a status' lease: who seems gone says soon that it is not.
TEST_F(Experiment, IsNotMistakenAfterItHasBeenStopped) {
  conduct();
  conductor_->signal(SIGSTOP);
  const auto stopped = RecordingBody::Clock::now();
  ASSERT_TRUE(answer_until(0.1, [&] {
    return RecordingBody::Clock::now() - stopped > std::chrono::milliseconds(1500);
  }));
  conductor_->signal(SIGCONT);
  const auto again = ends_.states().all().back().header.tick + 60;  // of 20 ms: beyond its patience
  ASSERT_TRUE(answer_until(0.1, [&] { return ends_.states().all().back().header.tick >= again; }));
  body_->change([](auto& fate) { fate.verdict = {true, "ran to the time limit"}; });
  EXPECT_THAT(result(), HasSubstr("result: success after"));
}

TEST_F(Experiment, SeesTheTickMasterGo) {
  conduct();
  stop();
  EXPECT_THAT(result(), HasSubstr("robot_bridge/0 is gone"));
}

}  // namespace
}  // namespace scarab::test
