#include <gmock/gmock.h>

#include <csignal>

#include "tests/support/ballast.hpp"
#include "tests/support/files.hpp"
#include "tests/support/status_watch.hpp"
#include "tests/system/stack.hpp"
#include "tests/system/trial_log.hpp"
#include "tests/system/view.hpp"

namespace scarab::test {
namespace {

using testing::HasSubstr;

constexpr std::chrono::seconds kTrialLimit{60};
constexpr std::int64_t kMostAhead = 64;  // ticks of the tick master over the log

class Logger : public testing::Test {
 protected:
  const bus::Peer plant_{"plant", 0};
  TemporaryDirectory directory_;
  View view_;
  StatusWatch status_;
};

TEST_F(Logger, StoppedLoggerHoldsTheTrialAndNothingIsLost) {
  Stack stack(directory_ / "stack");
  auto experiment = stack.conduct(main_trial());
  ASSERT_TRUE(view_.await_tick(40)) << experiment.out() << stack.errors();
  stack.service("logger").signal(SIGSTOP);
  std::int64_t held_at = 0;
  do {
    held_at = view_.tick();
  } while (eventually([&] { return view_.tick() > held_at; }, std::chrono::milliseconds(2500)));
  stack.service("logger").signal(SIGCONT);
  ASSERT_LE(experiment.wait(kTrialLimit).value_or(99), 1) << experiment.out() << stack.errors();
  EXPECT_TRUE(stack.stop()) << stack.errors();

  const auto trial = read_trial(stack.log());
  EXPECT_TRUE(contiguous_from_zero(trial.ticks));
  EXPECT_GT(static_cast<std::int64_t>(trial.ticks.size()), held_at + 10);  // it went on
  const auto wanted = directory_ / "undisturbed.mcap";
  ASSERT_LE(run(simulate(wanted), kTrialLimit).exit_code, 1);
  const auto result = compare(wanted, stack.log());
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
}

TEST_F(Logger, TickMasterIsNeverFarAhead) {
  Stack stack(directory_ / "stack");
  auto experiment = stack.conduct(main_trial());
  const bus::Peer logger{"logger", 0};
  std::int64_t recorded = 0;
  const bool stopped = eventually([&] {
    const auto report = status_.await(
        logger, [](const auto&) { return true; }, std::chrono::milliseconds(1));
    if (report && report->recorded_trial == 1) recorded = report->recorded_tick;
    return recorded >= 20;
  });
  ASSERT_TRUE(stopped) << experiment.out() << stack.errors();
  stack.service("logger").signal(SIGSTOP);
  ASSERT_TRUE(status_.await_message(plant_, "logger/0 has not recorded tick")) << stack.errors();
  status_.await(
      logger,
      [&](const auto& report) {
        recorded = std::max<std::int64_t>(recorded, report.recorded_tick);
        return false;
      },
      std::chrono::milliseconds(100));
  EXPECT_LE(view_.tick(), recorded + kMostAhead);
  stack.service("logger").signal(SIGCONT);
  EXPECT_LE(experiment.wait(kTrialLimit).value_or(99), 1) << experiment.out();
}

TEST_F(Logger, KilledLoggerLeavesEveryClosedChunkAndARestartedOneGoesOn) {
  Stack stack(directory_ / "stack");
  auto experiment = stack.conduct(main_trial());
  ASSERT_TRUE(view_.await_tick(130)) << experiment.out() << stack.errors();
  stack.kill("logger");
  const auto cut = std::filesystem::path(stack.log().string() + ".active");
  const auto kept = directory_ / "cut.mcap";
  std::filesystem::copy_file(cut, kept);
  stack.restart("logger");
  ASSERT_LE(experiment.wait(kTrialLimit).value_or(99), 1) << experiment.out() << stack.errors();
  EXPECT_TRUE(stack.stop()) << stack.errors();

  EXPECT_EQ(run({program("scarab-log"), "info", kept}).exit_code, 0);
  const auto mended = directory_ / "mended.mcap";
  const auto recovery = run({program("scarab-log"), "recover", kept, mended});
  ASSERT_EQ(recovery.exit_code, 0) << recovery.err;
  EXPECT_EQ(run({program("scarab-log"), "info", mended}).exit_code, 0);
  const auto trial = read_trial(mended);
  EXPECT_TRUE(contiguous_from_zero(trial.ticks));
  EXPECT_EQ(trial.ticks, read_trial(kept).ticks);  // recovery takes nothing away
  EXPECT_GE(trial.ticks.size(), 30U);

  // The restarted one writes a file of its own and has the rest of the trial.
  const auto rest = read_trial(directory_ / "stack" / "trial-2.mcap");
  ASSERT_FALSE(rest.ticks.empty());
  EXPECT_EQ(rest.ticks.back() - rest.ticks.front() + 1, rest.ticks.size());
  const auto undisturbed = directory_ / "undisturbed.mcap";
  ASSERT_LE(run(simulate(undisturbed), kTrialLimit).exit_code, 1);
  EXPECT_EQ(rest.ticks.back(), read_trial(undisturbed).ticks.back());
}

/// Lockstep waits for the disk as for everything, but not for ever.
TEST_F(Logger, OnAFullDiskTheTrialEndsForThatReasonAndIsRecordedOnceThereIsRoom) {
  constexpr std::uint64_t kMib = std::uint64_t{1} << 20U;
  constexpr std::uint64_t kMargin =
      256;  // MiB by which others may fill or empty the disk meanwhile
  const std::uint64_t free_mib = std::filesystem::space(directory_.path()).available / kMib;
  ASSERT_GT(free_mib, 3 * kMargin) << "too little room on the disk of " << directory_.path();
  write_text(directory_ / "logger.yaml",
             "free_disk_mib: " + std::to_string(free_mib - kMargin) + "\n");
  Stack::Options options;
  options.others = {"logger"};
  Stack stack(directory_ / "stack", options);
  ChildProcess logger = start({"logger",
                               stack.expect(),
                               stack.directory(),
                               0,
                               {"--output", stack.log(), "--config", directory_ / "logger.yaml"}});
  auto experiment = stack.conduct(main_trial());
  ASSERT_TRUE(view_.await_tick(40)) << experiment.out() << logger.err() << stack.errors();
  {
    const Ballast ballast(directory_ / "ballast", 2 * kMargin * kMib);
    ASSERT_TRUE(status_.await_message(plant_, "disk too full to record")) << stack.errors();
    ASSERT_TRUE(experiment.wait(kTrialLimit)) << stack.errors();
    const auto report = status_.await_health(plant_, scarab_HEALTH_FAULT);
    ASSERT_TRUE(report) << "how it ended shows after the trial, too";
    EXPECT_THAT(report->message, HasSubstr("has not recorded tick"));
    EXPECT_THAT(report->message, HasSubstr("disk too full to record"));
  }
  EXPECT_THAT(experiment.out(), HasSubstr("logger/0 has not recorded tick"));
  EXPECT_THAT(experiment.out(), HasSubstr("disk too full to record")) << experiment.err();
  EXPECT_TRUE(stack.stop()) << stack.errors();
  EXPECT_EQ(logger.stop(), 0) << logger.err();
  auto ticks = read_trial(stack.log()).ticks;
  const auto rest = read_trial(stack.directory() / "trial-2.mcap").ticks;
  ticks.insert(ticks.end(), rest.begin(), rest.end());
  EXPECT_TRUE(contiguous_from_zero(ticks));
  EXPECT_EQ(ticks.back(), view_.tick());
}

}  // namespace
}  // namespace scarab::test
