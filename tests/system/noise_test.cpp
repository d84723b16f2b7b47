// With sensors as they are (config/plant/beetle-noisy.yaml) the behaviours still come in their
// order, each for its reason.
#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/cdr.hpp"
#include "common/bus/topics.hpp"
#include "common/mcap/reader.hpp"
#include "tests/support/files.hpp"
#include "tests/support/test_bus.hpp"
#include "tests/system/stack.hpp"
#include "tests/system/trial_log.hpp"

namespace scarab::test {
namespace {

constexpr std::uint32_t kDomain = 96;
constexpr std::chrono::seconds kTrialLimit{60};
constexpr double kTriggerDelay =
    4;  // s; without noise mode 2 begins 1.9 to 3.1 s after the contact

/// What a trial's log says of the triggers, beside the ground truth.
struct Triggers {
  std::vector<scarab_BehaviourState> states;  ///< as they were entered
  std::optional<double> mode_2_s;             ///< when mode 2 began
  std::optional<double> blocked_s;            ///< when the object first touched the obstacle
  bool success = false;
};

double seconds(const scarab_Header& header) {
  return static_cast<double>(header.sim_time_ns) * 1e-9;
}

bool touches_obstacle(const scarab_WorldState& world) {
  const auto* begin = world.contacts._buffer;
  return std::any_of(begin, begin + world.contacts._length, [](const scarab_Contact& contact) {
    return std::minmax(contact.solid_a, contact.solid_b) ==
           std::minmax(scarab_SOLID_OBJECT, scarab_SOLID_OBSTACLE);
  });
}

Triggers read_triggers(const std::filesystem::path& log) {
  Triggers out;
  const mcap::Reader reader(log);
  reader.for_each(
      [&](const mcap::Channel& channel, const mcap::Message& message) {
        const sample::ByteView bytes{reinterpret_cast<const std::byte*>(message.data.data()),
                                     message.data.size()};
        if (channel.topic == bus::kWorldState.name) {
          const auto world = bus::decode<scarab_WorldState>(bytes);
          out.success = world->verdict == scarab_VERDICT_SUCCESS;
          if (!out.blocked_s && touches_obstacle(*world)) out.blocked_s = seconds(world->header);
          return;
        }
        const auto behaviour = bus::decode<scarab_Behaviour>(bytes);
        if (!out.states.empty() && out.states.back() == behaviour->state) return;
        out.states.push_back(behaviour->state);
        if (behaviour->state == scarab_BEHAVIOUR_MODE_2) out.mode_2_s = seconds(behaviour->header);
      },
      {bus::kWorldState.name, bus::kBehaviour.name});
  return out;
}

class Noise : public testing::Test {
 protected:
  /// The log of the main trial with the noisy plant, in one process.
  [[nodiscard]] std::filesystem::path simulated(const std::string& seed) const {
    auto log = directory_ / ("seed-" + seed + ".mcap");
    Arguments command = {
        program("scarab-sim"),   "--output", log, "--height", "0.10", "--seed", seed, "--plant",
        source_file(kNoisyPlant)};
    for (const std::string kind : {"robot", "premotor", "supervisor"}) {
      command.push_back("--" + kind);
      command.push_back(source_file("config/" + kind + "/beetle.yaml"));
    }
    const auto sim = run(command, kTrialLimit);
    EXPECT_LE(sim.exit_code, 1) << sim.out << sim.err;
    return log;
  }

  static constexpr const char* kNoisyPlant = "config/plant/beetle-noisy.yaml";
  TemporaryDirectory directory_;
};

/// The robot may slip off the object and climb again; from mode 1 on there is one way.
void expect_in_order(const std::vector<scarab_BehaviourState>& states) {
  const std::vector<scarab_BehaviourState> ending = {
      scarab_BEHAVIOUR_MODE_1, scarab_BEHAVIOUR_MODE_2, scarab_BEHAVIOUR_DONE};
  ASSERT_GE(states.size(), 5U);
  EXPECT_EQ(std::vector(states.end() - 3, states.end()), ending);
  for (std::size_t i = 0; i + 3 < states.size(); ++i) {
    EXPECT_EQ(states[i], i % 2 == 0 ? scarab_BEHAVIOUR_APPROACH : scarab_BEHAVIOUR_CLIMB) << i;
  }
}

TEST_F(Noise, BehavioursComeInTheirOrderEachForItsReason) {
  for (const std::string seed : {"1", "2", "3", "4", "5"}) {
    SCOPED_TRACE("seed " + seed);
    const Triggers seen = read_triggers(simulated(seed));
    EXPECT_TRUE(seen.success);
    expect_in_order(seen.states);
    ASSERT_TRUE(seen.mode_2_s && seen.blocked_s);
    EXPECT_GT(*seen.mode_2_s, *seen.blocked_s) << "switched before the object was blocked";
    EXPECT_LT(*seen.mode_2_s, *seen.blocked_s + kTriggerDelay);
  }
}

/// Errors are functions of the trial's seed, not of the process that draws them.
TEST_F(Noise, ProcessesReadTheSameBytesAsOneProcess) {
  const auto runs = directory_ / "runs";
  const auto stack = run({"/usr/bin/setsid", source_file("deploy/scarab"), "run", "--config",
                          std::string("plant=") + source_file(kNoisyPlant).string(), "--seed", "2",
                          "--domain", std::to_string(kDomain), "--tag", test_tag(), "--bin",
                          std::filesystem::path(program("x")).parent_path(), "--runs", runs},
                         kTrialLimit);
  ASSERT_EQ(stack.exit_code, 0) << stack.out << stack.err;
  const auto result = compare(simulated("2"), runs / "latest" / "trial.mcap");
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
}

}  // namespace
}  // namespace scarab::test
