#include "tests/system/launcher_rig.hpp"
#include "tests/system/two_hosts.hpp"

namespace scarab::test {
namespace {

using testing::HasSubstr;

/// The launcher on either of two hosts, with the shipped profiles.
class LauncherOnTwoHosts : public Launcher {
 protected:
  [[nodiscard]] Finished on(const Host& host, const Arguments& words,
                            const std::string& runs) const {
    const Arguments places = {"--domain", "0",
                              "--bin",    std::filesystem::path(program("x")).parent_path(),
                              "--runs",   runs_ / runs};
    return run(host.enter + Arguments{source_file("deploy/scarab")} + words + places, kRunLimit);
  }
};

TEST_F(LauncherOnTwoHosts, EachStartsItsOwnAndTheTrialRunsOnBoth) {
  const TwoHosts hosts(TwoHosts::Multicast::kOn);
  const Arguments cable = {"--interface", TwoHosts::kInterface};
  const auto plant =
      on(hosts.first(), Arguments{"up", "--profile", "plant-host", "--lockstep"} + cable, "plant");
  EXPECT_EQ(plant.exit_code, 0) << plant.err;
  EXPECT_THAT(plant.out, HasSubstr("not yet: logger/0 is missing, premotor/0 is missing"));
  const auto control =
      on(hosts.second(), Arguments{"up", "--profile", "control-host", "--lockstep"} + cable,
         "control");
  EXPECT_EQ(control.exit_code, 0) << control.err;
  EXPECT_THAT(control.out, HasSubstr("elsewhere: plant=1, all there"));
  const auto trial = on(hosts.second(), Arguments{"run", "--no-figure"} + kSuccess, "control");
  EXPECT_EQ(trial.exit_code, 0) << trial.out << trial.err;
  EXPECT_EQ(on(hosts.first(), {"down"}, "plant").exit_code, 0);
  EXPECT_EQ(on(hosts.second(), {"down"}, "control").exit_code, 0);
  EXPECT_THAT(living(), testing::IsEmpty());
}

}  // namespace
}  // namespace scarab::test
