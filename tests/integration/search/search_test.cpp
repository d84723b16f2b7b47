#include <gmock/gmock.h>

#include <csignal>
#include <sstream>

#include "tests/support/eventually.hpp"
#include "tests/support/files.hpp"
#include "tests/support/programs.hpp"

/// scarab-search from outside, on trials of a second or two.
namespace scarab::test {
namespace {

using testing::HasSubstr;

constexpr int kInterrupted = 130;
constexpr int kBadUsage = 2;

std::string description() {
  const std::string config = source_file("config");
  return "title: a test\nbase:\n  robot: " + config + "/robot/beetle.yaml\n  plant: " + config +
         "/plant/beetle.yaml\n  premotor: " + config +
         "/premotor/beetle.yaml\n  supervisor: " + config + R"(/supervisor/beetle.yaml
overrides: {plant.start.settle_s: 0.1}
parameters:
  premotor.motor.hind.t_gain_rad: {low: -5, high: 5}
  premotor.motor.hind.c_gain_rad: {low: -5, high: 5}
scenarios:
  - {name: walk, strategy: walk-backward, goal: walk, distance_m: 3, time_limit_s: 1.5, seeds: 1, weight: 1, wanted: straight}
  - {name: push, strategy: soft, goal: travel, distance_m: 0.05, time_limit_s: 8, seeds: 1, weight: 1}
seeds:
  search: {first: 1, last: 899999}
  validation: {first: 900001, last: 900001}
  held_out: {first: 2000001, last: 2000040}
optimiser: {population: 5, sigma: 0.05, validate_every: 3}
)";
}

class SearchProgram : public testing::Test {
 protected:
  SearchProgram() { write_text(file(), description()); }

  [[nodiscard]] std::string file() const { return folder_ / "search.yaml"; }
  [[nodiscard]] std::filesystem::path out(const std::string& name) const { return folder_ / name; }
  [[nodiscard]] Arguments command(const std::string& name, const Arguments& more = {}) const {
    Arguments words = {program("scarab-search"), "run", file(), "--quiet", "--out", out(name)};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  [[nodiscard]] int search(const std::string& name, const Arguments& more) const {
    const Finished finished = run(command(name, more));
    EXPECT_EQ(finished.err, "");
    return finished.exit_code;
  }
  void expect_equal(const std::string& a, const std::string& b) const {
    for (const char* kept : {"costs.csv", "history.csv", "winner.yaml"}) {
      EXPECT_NE(read_text(out(a) / kept), "") << kept;
      EXPECT_EQ(read_text(out(a) / kept), read_text(out(b) / kept)) << kept;
    }
  }

  TemporaryDirectory folder_;
};

std::size_t lines_in(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST_F(SearchProgram, RepeatsItselfOnAnyNumberOfThreads) {
  EXPECT_EQ(search("a", {"--generations", "2", "--jobs", "1"}), 0);
  EXPECT_EQ(search("b", {"--generations", "2", "--jobs", "3"}), 0);
  EXPECT_EQ(search("c", {"--generations", "2", "--seed", "2"}), 0);
  expect_equal("a", "b");
  EXPECT_NE(read_text(out("a") / "costs.csv"), read_text(out("c") / "costs.csv"));
  EXPECT_EQ(lines_in(out("a") / "history.csv"), 1U + 2U);
}

TEST_F(SearchProgram, RepeatsItselfWithTwoIslands) {
  for (const char* name : {"a", "b"}) {
    EXPECT_EQ(search(name, {"--generations", "2", "--islands", "2", "--jobs", "2"}), 0);
  }
  expect_equal("a", "b");
  EXPECT_EQ(lines_in(out("a") / "history.csv"), 1U + 2U * 2U);
}

TEST_F(SearchProgram, GoesOnAfterAnInterruptionAsIfThereHadBeenNone) {
  const Arguments until = {"--generations", "9", "--jobs", "2"};
  ChildProcess interrupted(command("a", until), out("interrupted"));
  ASSERT_TRUE(eventually([&] { return lines_in(out("a") / "costs.csv") > 2 * 5; }));
  interrupted.signal(SIGINT);
  ASSERT_EQ(interrupted.wait(kPatience), kInterrupted) << interrupted.output();
  EXPECT_THAT(interrupted.out(), HasSubstr("the same command goes on after generation"));
  ASSERT_LT(lines_in(out("a") / "costs.csv"), 1U + 9U * 5U) << "it had ended before";
  EXPECT_EQ(search("a", until), 0);
  EXPECT_EQ(search("b", until), 0);
  expect_equal("a", "b");
}

TEST_F(SearchProgram, RefusesTheDirectoryOfAnotherSearch) {
  ASSERT_EQ(search("a", {"--generations", "1"}), 0);
  const std::string before = read_text(out("a") / "costs.csv");
  const Finished other_seed = run(command("a", {"--seed", "2"}));
  EXPECT_EQ(other_seed.exit_code, kBadUsage);
  EXPECT_THAT(other_seed.err, HasSubstr("--seed 1 --islands 1"));
  std::string text = description();
  write_text(file(), text.replace(text.find("sigma: 0.05"), 11, "sigma: 0.06"));
  const Finished other_description = run(command("a"));
  EXPECT_EQ(other_description.exit_code, kBadUsage);
  EXPECT_THAT(other_description.err, HasSubstr("another description"));
  EXPECT_EQ(read_text(out("a") / "costs.csv"), before);
  EXPECT_EQ(search("a", {"--generations", "1", "--fresh"}), 0);
}

TEST_F(SearchProgram, WritesAWinnerThatTheServicesRead) {
  ASSERT_EQ(search("a", {"--generations", "3"}), 0);
  const Finished held_out = run({program("scarab-search"), "evaluate", file(), "--candidate",
                                 out("a"), "--held-out", "--seeds", "1"});
  EXPECT_EQ(held_out.exit_code, 0) << held_out.err;
  const Finished written =
      run({program("scarab-search"), "write", out("a"), "--to", folder_ / "config"});
  ASSERT_EQ(written.exit_code, 0) << written.err;
  const std::string file = folder_ / "config/premotor/beetle.yaml";
  EXPECT_EQ(written.out, file + "\n");
  EXPECT_THAT(read_text(file), HasSubstr("held-out seeds 2000001..2000001"));
  const Finished check = run({program("scarab-config"), "check", file});
  EXPECT_EQ(check.exit_code, 0) << check.err;
}

TEST_F(SearchProgram, EvaluatesTheBaseOnAllSeedsOfARangeUnlessToldOtherwise) {
  const Finished evaluated = run({program("scarab-search"), "evaluate", file()});
  EXPECT_EQ(evaluated.exit_code, 0) << evaluated.err;
  EXPECT_THAT(evaluated.out, testing::StartsWith("validation seeds 900001..900001\n"));
}

/// What is found is what is run later: the same trial, to the tick.
TEST_F(SearchProgram, EvaluatesTrialsAsTheSimulationRunsThem) {
  const Finished evaluated = run(
      {program("scarab-search"), "evaluate", file(), "--held-out", "--seeds", "1", "--failures"});
  ASSERT_EQ(evaluated.exit_code, 0) << evaluated.err;
  Arguments simulation = {program("scarab-sim"),
                          "--strategy",
                          "soft",
                          "--goal",
                          "travel",
                          "--height",
                          "0",
                          "--distance",
                          "0.05",
                          "--time-limit",
                          "8",
                          "--seed",
                          "2000001",
                          "--quiet"};
  for (const char* kind : {"robot", "plant", "premotor", "supervisor"}) {
    simulation.push_back(std::string("--") + kind);
    simulation.push_back(source_file(std::string("config/") + kind + "/beetle.yaml"));
  }
  const Finished simulated = run(simulation);
  std::istringstream table(evaluated.out);
  std::string word;
  while (table >> word && word != "push") continue;
  std::string successes;
  std::string time_s;
  table >> successes >> time_s;
  ASSERT_EQ(successes, "1/1") << evaluated.out;
  EXPECT_THAT(simulated.out, HasSubstr("success after " + time_s + " s")) << simulated.err;
}

TEST_F(SearchProgram, SaysWhereADescriptionIsWrong) {
  std::string text = description();
  write_text(file(), text.replace(text.find("premotor.motor.hind.t"), 21, "premotor.motor.tail.t"));
  const Finished finished = run(command("a"));
  EXPECT_EQ(finished.exit_code, kBadUsage);
  EXPECT_THAT(finished.err, HasSubstr("search.yaml:9:"));
  EXPECT_THAT(finished.err, HasSubstr("parameters.premotor.motor.tail.t_gain_rad: no number"));
  EXPECT_FALSE(std::filesystem::exists(out("a"))) << "nothing was begun";
  const Finished checked = run({program("scarab-search"), "check", file()});
  EXPECT_EQ(checked.exit_code, kBadUsage);
  EXPECT_EQ(checked.err, finished.err);
}

TEST_F(SearchProgram, ReadsTheShippedDescriptions) {
  for (const char* name : {"beetle", "beetle-heading", "example"}) {
    const std::string shipped = source_file(std::string("config/search/") + name + ".yaml");
    const Finished checked = run({program("scarab-search"), "check", shipped});
    EXPECT_EQ(checked.exit_code, 0) << checked.err;
    EXPECT_EQ(checked.out, shipped + ": ok\n");
  }
}

}  // namespace
}  // namespace scarab::test
