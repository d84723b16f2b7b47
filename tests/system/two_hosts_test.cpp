#include "tests/system/two_hosts.hpp"

#include <gmock/gmock.h>

#include "tests/support/eventually.hpp"
#include "tests/support/files.hpp"
#include "tests/system/stack.hpp"
#include "tests/system/trial_log.hpp"

namespace scarab::test {
namespace {

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
    expect_as_in_one_process(stack.log());
  }
  void expect_as_in_one_process(const std::filesystem::path& log) {
    const auto wanted = directory_ / "sim.mcap";
    ASSERT_EQ(run(simulate(wanted)).exit_code, 0);
    const auto result = compare(wanted, log);
    EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  }

  /// Until somebody on the host has joined domain 0 and announced himself.
  static void await_discovery_socket(const Host& host) {
    const Arguments look = {"/bin/grep", "-q", ":1CE8 ", "/proc/net/udp"};  // port 7400
    EXPECT_TRUE(eventually([&] { return TwoHosts::run_on(host, look).exit_code == 0; }));
  }

  TemporaryDirectory directory_;
};

TEST_F(TwoHostStack, RunsTheSameTrialAsOneProcess) { expect_same_trial(TwoHosts::Multicast::kOn); }

TEST_F(TwoHostStack, NeedsNoMulticastWhenItIsToldItsPeers) {
  expect_same_trial(TwoHosts::Multicast::kOff);
}

TEST_F(TwoHostStack, GoesOnAfterTheCableWasOutForAMoment) {
  const TwoHosts hosts(TwoHosts::Multicast::kOn);
  Stack stack(directory_ / "stack", spread_over(hosts));
  auto experiment = stack.conduct(main_trial());
  ASSERT_TRUE(eventually([&] { return experiment.out().find("climb") != std::string::npos; }))
      << experiment.output() << stack.errors();
  TwoHosts::pull_out(hosts.first());
  EXPECT_FALSE(eventually([&] { return !experiment.running(); }, std::chrono::milliseconds(400)));
  TwoHosts::plug_in(hosts.first());
  ASSERT_EQ(experiment.wait(kTrialLimit), 0) << experiment.output() << stack.errors();
  EXPECT_TRUE(stack.stop()) << stack.errors();
  expect_as_in_one_process(stack.log());
}

/// One lost datagram must not keep a restarted service out of a running trial.
TEST_F(TwoHostStack, FindsOutSoonWhoWasNotHeardAtFirst) {
  const TwoHosts hosts(TwoHosts::Multicast::kOn);
  TwoHosts::pull_out(hosts.second());
  const auto plant = start({"plant", "", directory_.path(), 0, {}, "beetle", hosts.first()});
  await_discovery_socket(hosts.first());
  TwoHosts::plug_in(hosts.second());
  TwoHosts::pull_out(hosts.first());
  auto wait = command_on(hosts.second(), "scarab-status");
  wait.insert(wait.end(), {"--wait", "plant=1", "--timeout", "20"});
  ChildProcess waiting(wait, directory_ / "waiting");
  await_discovery_socket(hosts.second());
  EXPECT_TRUE(waiting.running()) << waiting.output();
  TwoHosts::plug_in(hosts.first());
  EXPECT_EQ(waiting.wait(std::chrono::seconds(4)), 0) << waiting.output() << plant.err();
}

/// A tool that knows nothing of the stack's options, configured by the shipped file alone.
class ForeignTool : public TwoHostStack {
 protected:
  void expect_to_find_the_plant(TwoHosts::Multicast multicast, const Arguments& environment) {
    const TwoHosts hosts(multicast);
    const Stack stack(directory_ / "stack", spread_over(hosts));
    const auto uri = "file://" + source_file("deploy/cyclonedds/two-hosts.xml").string();
    Arguments list = {"/usr/bin/env", "CYCLONEDDS_URI=" + uri,
                      std::string("SCARAB_INTERFACE=") + TwoHosts::kInterface};
    list.insert(list.end(), environment.begin(), environment.end());
    list.insert(list.end(), {program("scarab-topic"), "list"});
    Finished listed;
    EXPECT_TRUE(eventually([&] {
      listed = TwoHosts::run_on(hosts.second(), list);
      return listed.out.find("plant/0") != std::string::npos;
    })) << listed.out
        << listed.err;
    EXPECT_THAT(listed.out, HasSubstr("scarab/robot_state"));
  }
};

TEST_F(ForeignTool, FindsTheStackByMulticast) {
  expect_to_find_the_plant(TwoHosts::Multicast::kOn, {});
}

TEST_F(ForeignTool, FindsTheStackByItsPeers) {
  expect_to_find_the_plant(
      TwoHosts::Multicast::kOff,
      {"SCARAB_MULTICAST=false", std::string("SCARAB_PEER_1=") + TwoHosts::kFirstAddress,
       std::string("SCARAB_PEER_2=") + TwoHosts::kSecondAddress});
}

/// As a person does it (docs/two-hosts.md).
class LauncherOnTwoHosts : public TwoHostStack {
 protected:
  /// The launcher's options on both hosts, but for the directory of the runs.
  std::string options(const std::string& more) const {
    return " --bin '" + std::filesystem::path(program("scarab")).parent_path().string() + "' " +
           more;
  }
  /// Starts the plant's half on the first host; stops it when the other half's end is marked.
  ChildProcess plant_host(const TwoHosts& hosts, const std::string& more) const {
    return TwoHosts::start_script(hosts.first(),
                                  R"(
      deploy/scarab up --lockstep --profile plant-host )" +
                                      options(more) + " --runs " + runs("first") + R"( || exit 1
      for moment in $(seq 600); do
        [ -e )" + over_.string() + R"( ] && break
        sleep 0.1
      done
      deploy/scarab down )" + options("") +
                                      " --runs " + runs("first"),
                                  directory_ / "first");
  }
  /// The shipped stack.yaml with the cable and the other host's address in it.
  std::string stack_with_peer(const std::string& address) const {
    const auto set = [](std::string& text, const std::string& key, const std::string& value) {
      const auto line = text.find("  " + key + ": ");
      ASSERT_NE(line, std::string::npos) << "no " << key << " in stack.yaml";
      text.replace(line, text.find('\n', line) - line, "  " + key + ": " + value);
    };
    std::string text = read_text(source_file("deploy/stack.yaml"));
    set(text, "interface", TwoHosts::kInterface);
    set(text, "peers", "[" + address + "]");
    const auto file = directory_ / ("stack-" + address + ".yaml");
    write_text(file, text);
    return "--stack " + file.string();
  }
  std::string runs(const std::string& host) const {
    return (directory_ / (host + "-runs")).string();
  }

  /// One trial, by these options of the launcher on the first and on the second host.
  void expect_same_trial(const TwoHosts& hosts, const std::string& first,
                         const std::string& second) {
    auto plant = plant_host(hosts, first);
    auto control = TwoHosts::start_script(hosts.second(),
                                          "deploy/scarab run --no-figure --profile control-host " +
                                              options(second) + " --runs " + runs("second") +
                                              " --strategy soft+hard --height 0.10 --seed 1",
                                          directory_ / "second");
    EXPECT_EQ(control.wait(kTrialLimit), 0) << control.output() << plant.output();
    write_text(over_, "");
    EXPECT_EQ(plant.wait(kTrialLimit), 0) << plant.output();
    EXPECT_THAT(plant.out(), HasSubstr("elsewhere: logger=1,supervisor=1,premotor=1"));
    expect_as_in_one_process(std::filesystem::path(runs("second")) / "latest" / "trial.mcap");
  }

  std::filesystem::path over_ = directory_ / "over";
};

TEST_F(LauncherOnTwoHosts, RunsTheSameTrial) {
  const TwoHosts hosts(TwoHosts::Multicast::kOn);
  expect_same_trial(hosts, "--interface cable", "--interface cable");
}

TEST_F(LauncherOnTwoHosts, TakesThePeersFromTheStackFile) {
  const TwoHosts hosts(TwoHosts::Multicast::kOff);
  expect_same_trial(hosts, stack_with_peer(TwoHosts::kSecondAddress),
                    stack_with_peer(TwoHosts::kFirstAddress));
}

}  // namespace
}  // namespace scarab::test
