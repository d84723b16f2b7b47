#include "tests/system/two_hosts.hpp"

#include <gmock/gmock.h>

#include "tests/support/files.hpp"
#include "tests/system/stack.hpp"
#include "tests/system/trial_log.hpp"

namespace scarab::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr std::chrono::seconds kTrialLimit{60};

/// The plant on one host, all else on the other.
class TwoHostStack : public testing::Test {
 protected:
  static Stack::Options spread_over(const TwoHosts& hosts) {
    Stack::Options options;
    options.plant_host = hosts.first();
    options.host = hosts.second();
    return options;
  }

  /// The trial on such a stack is that of one process, byte for byte.
  void expect_same_trial(TwoHosts::Multicast multicast) {
    const TwoHosts hosts(multicast);
    Stack stack(directory_ / "stack", spread_over(hosts));
    auto experiment = stack.conduct(main_trial());
    ASSERT_EQ(experiment.wait(kTrialLimit), 0) << experiment.output() << stack.errors();
    EXPECT_TRUE(stack.stop()) << stack.errors();
    const auto in_one_process = directory_ / "sim.mcap";
    ASSERT_EQ(run(simulate(in_one_process)).exit_code, 0);
    const auto result = compare(in_one_process, stack.log());
    EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  }

  TemporaryDirectory directory_;
};

TEST_F(TwoHostStack, RunsTheSameTrialAsOneProcess) { expect_same_trial(TwoHosts::Multicast::kOn); }

TEST_F(TwoHostStack, NeedsNoMulticastWhenItIsToldItsPeers) {
  expect_same_trial(TwoHosts::Multicast::kOff);
}

}  // namespace
}  // namespace scarab::test
