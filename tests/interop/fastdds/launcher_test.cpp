/// The launcher starts a premotor controller on another vendor's DDS from a copy of the stack file.
#include <gmock/gmock.h>

#include <optional>

#include "tests/interop/domain_claim.hpp"
#include "tests/support/files.hpp"
#include "tests/system/trial_log.hpp"

namespace scarab::test {
namespace {

using testing::HasSubstr;

/// deploy/stack.yaml with another program for one service.
std::string stack_file_with(const std::string& ours, const std::string& theirs) {
  std::string text = read_text(source_file("deploy/stack.yaml"));
  const std::string entry = "binary: " + ours + "\n";
  const auto at = text.find(entry);
  if (at == std::string::npos) throw std::runtime_error("deploy/stack.yaml has no " + entry);
  return text.replace(at, entry.size(), "binary: " + theirs + "\n");
}

TEST(FastDdsLauncher, OneLineOfTheStackFileSwapsThePremotorController) {
  const TemporaryDirectory directory;
  write_text(directory / "stack.yaml", stack_file_with("scarab-premotor", "fastdds-premotor"));
  std::optional<DomainClaim> claim(std::in_place);
  const std::string domain = std::to_string(claim->domain());
  claim.reset();  // the launcher makes its own
  const auto bin = std::filesystem::path(program("fastdds-premotor")).parent_path();
  const Finished result =
      run({source_file("deploy/scarab"), "run", "--stack", directory / "stack.yaml", "--bin", bin,
           "--runs", directory / "runs", "--domain", domain, "--no-figure", "--height", "0.10"},
          std::chrono::seconds(60));
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_THAT(result.out, HasSubstr("result: success"));
  const auto state = directory / "runs/latest/state/fastdds-premotor-0.state";
  EXPECT_TRUE(std::filesystem::exists(state)) << "somebody else was the premotor controller";
}

}  // namespace
}  // namespace scarab::test
