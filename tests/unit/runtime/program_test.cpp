#include "common/runtime/program.hpp"

#include <gmock/gmock.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <stdexcept>

#include "common/config/error.hpp"
#include "common/runtime/options.hpp"

namespace scarab::runtime {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

struct Result {
  int code;
  std::string err;
  bool body_ran = false;

  [[nodiscard]] auto lines() const { return std::count(err.begin(), err.end(), '\n'); }
};

Result run(std::vector<std::string> arguments, const std::function<int()>& body) {
  CLI::App app{"A test program.", "scarab-test"};
  ServiceOptions options;
  add_service_options(app, options);
  arguments.insert(arguments.begin(), "scarab-test");
  std::vector<char*> argv;
  for (auto& argument : arguments) argv.push_back(argument.data());
  Result result{};
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  result.code = run_program(app, static_cast<int>(argv.size()), argv.data(), [&] {
    result.body_ran = true;
    return body();
  });
  result.err = testing::internal::GetCapturedStderr();
  testing::internal::GetCapturedStdout();
  return result;
}

int succeed() { return kExitSuccess; }

TEST(Program, PassesTheBodysExitCodeOn) {
  EXPECT_EQ(run({}, succeed).code, 0);
  EXPECT_EQ(run({}, [] { return kExitFailure; }).code, 1);
}

TEST(Program, BadCommandLineIsOneLineAndNothingRuns) {
  for (const std::vector<std::string>& bad : {std::vector<std::string>{"--no-such-option"},
                                              {"--instance"},
                                              {"--instance", "16"},
                                              {"--domain", "231"},
                                              {"--domain", "x"},
                                              {"--log-level", "loud"},
                                              {"--expect", "plant"},
                                              {"stray"}}) {
    const auto result = run(bad, succeed);
    EXPECT_EQ(result.code, kExitBadUsage) << bad.front();
    EXPECT_FALSE(result.body_ran) << bad.front();
    EXPECT_EQ(result.lines(), 1) << result.err;
    EXPECT_THAT(result.err, StartsWith("scarab-test: "));
  }
}

TEST(Program, HelpIsASuccess) {
  const auto result = run({"--help"}, succeed);
  EXPECT_EQ(result.code, kExitSuccess);
  EXPECT_FALSE(result.body_ran);
}

TEST(Program, BadConfigurationIsItsOwnLine) {
  const auto result = run({}, []() -> int {
    throw config::Error("beetle.yaml", {3, 5}, "legs", "unknown key");
  });
  EXPECT_EQ(result.code, kExitBadUsage);
  EXPECT_EQ(result.err, "beetle.yaml:3:5: legs: unknown key\n");
}

TEST(Program, AnyOtherErrorIsAFailureAtRunTime) {
  const auto result = run({}, []() -> int { throw std::runtime_error("the bus is full"); });
  EXPECT_EQ(result.code, kExitFailure);
  EXPECT_EQ(result.err, "scarab-test: the bus is full\n");
}

}  // namespace
}  // namespace scarab::runtime
