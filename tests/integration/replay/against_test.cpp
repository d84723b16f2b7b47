/// Services against recorded robots: `scarab-log replay LOG --against SERVICE`.
#include <algorithm>
#include <optional>

#include "common/bus/cdr.hpp"
#include "common/mcap/reader.hpp"
#include "common/runtime/status_publisher.hpp"
#include "tests/integration/replay/fixture.hpp"
#include "tests/support/status_watch.hpp"

namespace scarab::test {
namespace {

using testing::HasSubstr;

class Against : public ReplayTest {
 protected:
  /// A trial recorded by the simulation in one process: the samples of a lockstep run of the stack.
  std::filesystem::path simulated(const Arguments& trial = main_trial()) {
    const auto log = directory_ / "simulated.mcap";
    const Finished done = run(simulate(log, trial), std::chrono::seconds(60));
    EXPECT_EQ(done.exit_code, 0) << done.err;
    return log;
  }
  ChildProcess start_service(const std::string& name, const std::string& expect = "",
                             const std::string& run_dir = "fresh") {
    std::filesystem::create_directories(directory_ / run_dir);
    return start({name, expect, directory_ / run_dir, 0, {}});
  }
  /// A configuration of the supervisor that is not the shipped one.
  static std::string changed(const std::string& change) {
    return "extends: " + source_file("config/supervisor/beetle.yaml").string() + "\n" + change;
  }
  /// A supervisor with one parameter that is not the shipped one.
  ChildProcess start_changed_supervisor(const std::string& change) {
    const auto config = directory_ / "changed.yaml";
    write_text(config, changed(change));
    return {{program("scarab-supervisor"), "--tag", test_tag(), "--config", config},
            directory_ / "changed"};
  }
  /// The first tick of a log at which the supervisor says another mode than before.
  static std::uint32_t first_change_of_mode(const std::filesystem::path& log) {
    std::optional<scarab_Mode> mode;
    std::optional<std::uint32_t> tick;
    mcap::Reader(log).for_each(
        [&](const mcap::Channel&, const mcap::Message& message) {
          const auto* bytes = reinterpret_cast<const std::byte*>(message.data.data());
          const auto behaviour = bus::decode<scarab_Behaviour>({bytes, message.data.size()});
          if (mode && *mode != behaviour->mode && !tick) tick = behaviour->header.tick;
          mode = behaviour->mode;
        },
        {bus::kBehaviour.name});
    return tick.value();
  }
};

TEST_F(Against, TheServicesOfARecordedRunGiveTheAnswersTheyGave) {
  std::string expect;
  std::filesystem::path log;
  {
    Stack stack(directory_ / "stack");
    auto experiment = stack.conduct(main_trial());
    ASSERT_EQ(experiment.wait(std::chrono::seconds(60)), 0) << experiment.err() << stack.errors();
    ASSERT_TRUE(stack.stop()) << stack.errors();
    log = stack.log();
    expect = stack.expect();
  }
  {
    const auto supervisor = start_service("supervisor", expect);
    const Finished done = replay(log, {"--against", "supervisor"});
    EXPECT_EQ(done.exit_code, 0) << done.out << done.err << supervisor.err();
    EXPECT_THAT(done.out, HasSubstr("behaviour: 177 of 177 answers equal\n"));
  }
  const auto premotor = start_service("premotor", expect);
  const Finished done = replay(log, {"--against", "premotor"});
  EXPECT_EQ(done.exit_code, 0) << done.out << done.err << premotor.err();
  EXPECT_THAT(done.out, HasSubstr("joint_command: 177 of 177 answers equal\n"));
  EXPECT_THAT(done.out, HasSubstr("neural_activity: 177 of 177 answers equal\n"));
}

TEST_F(Against, AChangedServiceAnswersOtherwiseFromTheTickOnWhereItMust) {
  const auto log = simulated();
  const auto supervisor = start_changed_supervisor("bs: {settle_ticks: 8}\n");  // 6 as shipped
  const Finished done = replay(log, {"--against", "supervisor"});
  EXPECT_EQ(done.exit_code, 1) << done.err << supervisor.err();
  const std::string tick = std::to_string(first_change_of_mode(log));
  EXPECT_THAT(done.out, HasSubstr("first other behaviour: trial 1, tick " + tick + " ("));
  EXPECT_THAT(done.out, HasSubstr("s): mode: recorded \"MODE_SOFT_PUSH\", answered "
                                  "\"MODE_BACKWARD\"\n"));
  EXPECT_THAT(done.out, HasSubstr(" of 177 answers equal\n"));
}

TEST_F(Against, WhatMayDifferIsSaid) {
  const auto log = simulated(
      {"--strategy", "walk-forward", "--goal", "none", "--height", "0", "--time-limit", "3"});
  const auto supervisor = start_changed_supervisor("backbone_rad: 0.07789\n");  // 0.07788
  const Finished strict = replay(log, {"--against", "supervisor"});
  EXPECT_EQ(strict.exit_code, 1);
  EXPECT_THAT(strict.out, HasSubstr("backbone_rad: recorded 0.07788, answered 0.07789\n"));
  const Finished tolerant = replay(log, {"--against", "supervisor", "--tolerance", "1e-4"});
  EXPECT_EQ(tolerant.exit_code, 0) << tolerant.out << tolerant.err;
  EXPECT_THAT(tolerant.out, HasSubstr("(as trial 2)")) << "it has seen trial 1";
  const Finished without = replay(log, {"--against", "supervisor", "--ignore", "backbone_rad"});
  EXPECT_EQ(without.exit_code, 0) << without.out << without.err;
}

TEST_F(Against, AtThePaceOfTheClockToo) {
  const auto log = simulated({"--strategy", "walk-forward", "--goal", "none", "--height", "0",
                              "--time-limit", "3", "--trials", "2"});
  const auto premotor = start_service("premotor", "plant=1,supervisor=1");
  const Finished done = replay(log, {"--against", "premotor", "--speed", "0.05"});
  EXPECT_EQ(done.exit_code, 0) << done.out << done.err << premotor.err();
  EXPECT_THAT(done.out, HasSubstr("joint_command: 62 of 62 answers equal\n"));
}

TEST_F(Against, NobodyThereIsSaid) {
  const Finished done = replay(simulated({"--time-limit", "0.5", "--goal", "none"}),
                               {"--against", "supervisor", "--timeout", "0.5"});
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_THAT(done.err, HasSubstr("supervisor/0 is not there after 0.5 s"));
}

/// A supervisor that says it is ready, and then nothing.
TEST_F(Against, ASilentServiceIsNamedWithWhatItDoesNotAnswer) {
  const auto log = simulated({"--time-limit", "0.5", "--goal", "none"});
  bus::Participant participant(test_options("supervisor"));
  bus::Reader<scarab_Trial> trials(participant, bus::kTrial);
  const bus::Reader<scarab_RobotState> states(participant, bus::kRobotState);
  const bus::Writer<scarab_Behaviour> behaviours(participant, bus::kBehaviour);
  runtime::StatusPublisher status(participant, {"supervisor", 0});
  status.publish_if_due();
  auto replaying = start_replay(log, {"--against", "supervisor", "--timeout", "1"});
  ASSERT_TRUE(eventually([&] {
    trials.take([&](const scarab_Trial& trial) {
      status.set_ready(trial.header.trial);
      status.set_health(scarab_HEALTH_OK, "thinking");
    });
    status.publish_if_due();
    return !replaying.running();
  }));
  EXPECT_EQ(replaying.wait(kPatience), 1);
  EXPECT_THAT(replaying.err(), HasSubstr("supervisor/0 has not answered tick 0 of trial 1 on "
                                         "scarab/behaviour for 1.0 s; it says: thinking"));
  EXPECT_THAT(replaying.out(), HasSubstr("behaviour: 0 of 0 answers equal"));
}

TEST_F(Against, ATrialThatTheServiceRefusesEndsWithItsReason) {
  write_text(directory_ / "more.yaml",
             changed("strategies: {waltz: {approach: stop, push: []}}\n"));
  const auto log = directory_ / "waltz.mcap";
  Arguments command =
      simulate(log, {"--strategy", "waltz", "--time-limit", "0.5", "--goal", "none"});
  *(std::find(command.begin(), command.end(), "--supervisor") + 1) = directory_ / "more.yaml";
  ASSERT_EQ(run(command).exit_code, 0);
  const auto supervisor = start_service("supervisor");
  const Finished done = replay(log, {"--against", "supervisor"});
  EXPECT_EQ(done.exit_code, 1) << done.out << supervisor.err();
  EXPECT_THAT(done.err, HasSubstr("supervisor/0 refuses trial 1; it says: trial 1: "));
}

TEST_F(Against, BadUsageIsRefusedBeforeAnythingStarts) {
  const auto log = simulated({"--time-limit", "0.5", "--goal", "none"});
  const Finished who = replay(log, {"--against", "plant"});
  EXPECT_EQ(who.exit_code, 2);
  EXPECT_THAT(who.err, HasSubstr("there are supervisor and premotor"));
  EXPECT_EQ(replay(log, {"--against", "premotor/x"}).exit_code, 2);
  EXPECT_EQ(replay(log, {"--against", "premotor", "--loop"}).exit_code, 2);
  EXPECT_EQ(replay(log, {"--speed", "fast"}).exit_code, 2);
  EXPECT_EQ(replay(log, {"--tolerance", "1"}).exit_code, 2);
  EXPECT_EQ(replay(log, {"--topic", "nothing"}).exit_code, 2);
}

}  // namespace
}  // namespace scarab::test
