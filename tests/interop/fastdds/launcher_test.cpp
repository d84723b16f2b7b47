/// The launcher starts a premotor controller on another vendor's DDS from a copy of the stack file.
#include <gmock/gmock.h>

#include "tests/interop/domain_claim.hpp"
#include "tests/support/files.hpp"
#include "tests/support/programs.hpp"

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

/// `scarab run` on the first domain of the tests that no other stack has; the launcher claims its
/// own.
Finished run_on_a_free_domain(const std::filesystem::path& stack_file,
                              const std::filesystem::path& runs) {
  const auto bin = std::filesystem::path(program("fastdds-premotor")).parent_path();
  Finished result;
  for (std::uint32_t domain = DomainClaim::kFirst; domain <= DomainClaim::kLast; ++domain) {
    result =
        run({source_file("deploy/scarab"), "run", "--stack", stack_file, "--bin", bin, "--runs",
             runs, "--domain", std::to_string(domain), "--no-figure", "--height", "0.10"},
            std::chrono::seconds(60));
    if (result.err.find("is in use by another stack") == std::string::npos) break;
  }
  return result;
}

TEST(FastDdsLauncher, OneLineOfTheStackFileSwapsThePremotorController) {
  const TemporaryDirectory directory;
  write_text(directory / "stack.yaml", stack_file_with("scarab-premotor", "fastdds-premotor"));
  const Finished result = run_on_a_free_domain(directory / "stack.yaml", directory / "runs");
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_THAT(result.out, HasSubstr("result: success"));
  const auto state = directory / "runs/latest/state/fastdds-premotor-0.state";
  EXPECT_TRUE(std::filesystem::exists(state)) << "somebody else was the premotor controller";
}

}  // namespace
}  // namespace scarab::test
