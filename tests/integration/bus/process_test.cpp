// Two processes on one bus.
#include <gmock/gmock.h>
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <iostream>

#include "common/bus/reader.hpp"
#include "common/bus/topics.hpp"
#include "common/bus/waitset.hpp"
#include "common/bus/writer.hpp"
#include "tests/integration/bus/fixture.hpp"

namespace scarab::bus {
namespace {

using std::chrono::seconds;
using testing::ElementsAre;
using testing::IsEmpty;

/// bus_echo_peer, killed with this object.
class EchoPeer {
 public:
  explicit EchoPeer(std::string tag) {
    std::string program = BUS_ECHO_PEER;
    std::array<char*, 3> arguments{program.data(), tag.data(), nullptr};
    EXPECT_EQ(posix_spawn(&pid_, program.c_str(), nullptr, nullptr, arguments.data(), environ), 0);
  }
  EchoPeer(const EchoPeer&) = delete;
  EchoPeer& operator=(const EchoPeer&) = delete;
  ~EchoPeer() { kill(); }

  void kill() {
    if (pid_ <= 0) return;
    ::kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
    pid_ = 0;
  }

 private:
  pid_t pid_ = 0;
};

struct TwoProcesses : testing::Test {
  ParticipantOptions options = test_options("plant");
  Participant plant{options};
  Writer<scarab_RobotState> writer{plant, kRobotState};
  Reader<scarab_JointCommand> reader{plant, kJointCommand};
  Reader<scarab_ServiceStatus> status{plant, kServiceStatus};
  WaitSet waitset{plant};
  EchoPeer peer{options.tag};

  void SetUp() override {
    ASSERT_TRUE(eventually([&] { return !writer.matched().empty() && !reader.matched().empty(); }));
  }

  /// Seconds until the peer's answer to one robot_state.
  double round_trip_s(std::uint32_t tick) {
    scarab_RobotState state{};
    state.header.tick = tick;
    const auto begin = std::chrono::steady_clock::now();
    writer.write(state);
    bool answered = false;
    while (!answered && waitset.wait(seconds(10))) {
      reader.take([&](const scarab_JointCommand& c) { answered = c.header.tick == tick; });
    }
    EXPECT_TRUE(answered) << tick;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
};

TEST_F(TwoProcesses, AnswerEachOther) {
  EXPECT_THAT(reader.matched(), ElementsAre(Peer{"premotor", 1}));
  waitset.attach(reader);
  constexpr std::uint32_t kRounds = 2000;
  std::vector<double> times;
  for (std::uint32_t tick = 0; tick < kRounds && !HasFailure(); ++tick) {
    times.push_back(round_trip_s(tick));
  }
  std::sort(times.begin(), times.end());
  std::cout << "robot_state to joint_command, round trip: p50 " << times[kRounds / 2] * 1e6
            << " us, p99 " << times[kRounds * 99 / 100] * 1e6 << " us\n";
}

TEST_F(TwoProcesses, AKilledOneIsMissedWithinTwoSeconds) {
  waitset.attach(status);
  const auto take_states = [&] {
    std::vector<InstanceState> states;
    status.take_with_info([&](const scarab_ServiceStatus& s, const SampleInfo& info) {
      EXPECT_STREQ(s.service, "premotor");
      states.push_back(info.state);
    });
    return states;
  };
  ASSERT_TRUE(waitset.wait(seconds(10)));
  ASSERT_THAT(take_states(), ElementsAre(InstanceState::kAlive));

  const auto begin = std::chrono::steady_clock::now();
  peer.kill();
  ASSERT_TRUE(waitset.wait(seconds(10)));
  const auto noticed = std::chrono::steady_clock::now() - begin;
  EXPECT_THAT(take_states(), ElementsAre(InstanceState::kNoWriters));
  EXPECT_LT(noticed, seconds(2));
  std::cout << "kill -9 noticed after " << std::chrono::duration<double>(noticed).count() << " s\n";
  EXPECT_TRUE(eventually([&] { return reader.matched().empty(); }, seconds(15)));
}

}  // namespace
}  // namespace scarab::bus
