#include <gmock/gmock.h>

#include <algorithm>

#include "common/bus/discovery.hpp"
#include "tests/integration/emulator/emulator_process.hpp"
#include "tests/integration/emulator/line.hpp"
#include "tests/integration/emulator/world_sight.hpp"

/// What the emulator has to do with the bus, and its world with trials.
namespace scarab::test {
namespace {

using ::testing::ElementsAre;
using ::testing::UnorderedElementsAre;

class EmulatorOnTheBus : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(eventually([&] { return sight_.is_met(); }));
  }

  const dxl::ServoModel& model_ = DynamixelLine::kModel;
  EmulatorProcess emulator_;
  DynamixelLine line_{emulator_.device()};
  WorldSight sight_;
};

TEST_F(EmulatorOnTheBus, ReadsTheTrialAndWritesTheWorldAndNothingElse) {
  bus::Participant participant(test_options("view"));
  bus::Discovery discovery(participant);
  std::vector<std::string> own;
  const auto look = [&] {
    discovery.update();
    own.clear();
    for (const auto& endpoint : discovery.endpoints()) {
      if (endpoint.peer.service != "emulator") continue;
      own.push_back((endpoint.kind == bus::EndpointKind::kWriter ? "writes " : "reads ") +
                    endpoint.topic);
    }
    return own.size() >= 2;
  };
  ASSERT_TRUE(eventually(look));
  sight_.tell_trial(1);
  ASSERT_TRUE(sight_.first_of(1));
  ASSERT_TRUE(line_.power_all());
  ASSERT_TRUE(sight_.await([](const auto& seen) { return seen.header.tick > 2; }));
  look();
  EXPECT_THAT(own, UnorderedElementsAre("reads scarab/trial", "writes scarab/world_state"));
}

TEST_F(EmulatorOnTheBus, TheWorldBeginsWithTheFirstTorque) {
  sight_.tell_trial(1, 1000, 0.1);
  const auto first = sight_.first_of(1);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->header.tick, 0U);
  EXPECT_EQ(first->header.sim_time_ns, 0);
  EXPECT_TRUE(first->obstacle);
  const auto standing = line_.read(8, model_.present_position);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(line_.read(8, model_.present_position), standing);
  for (const auto& seen : sight_.all()) EXPECT_EQ(seen.header.sim_time_ns, 0) << "it stands still";

  ASSERT_TRUE(line_.power_all());
  ASSERT_TRUE(sight_.await([](const auto& seen) { return seen.header.tick >= 5; }));
  std::int64_t time_ns = 0;
  for (const auto& seen : sight_.all()) {
    EXPECT_EQ(seen.header.tick, seen.header.sim_time_ns / 100'000'000);
    if (seen.header.sim_time_ns == 0) continue;
    EXPECT_EQ(seen.header.sim_time_ns, time_ns + 20'000'000) << "each sensor period";
    time_ns = seen.header.sim_time_ns;
  }
}

TEST_F(EmulatorOnTheBus, WithoutTorqueTheRobotSinks) {
  sight_.tell_trial(1);
  const auto stood = sight_.first_of(1);
  ASSERT_TRUE(stood && line_.power_all());
  ASSERT_TRUE(sight_.await([](const auto& seen) { return seen.header.tick >= 5; }));
  EXPECT_NEAR(sight_.all().back().trunk_height_m, stood->trunk_height_m, 0.02) << "it holds";
  line_.send(dxl::encode(dxl::write(dxl::kBroadcastId, model_.torque_enable.address, Bytes{0})));
  EXPECT_TRUE(sight_.await([&](const auto& seen) {
    return seen.trunk_height_m < stood->trunk_height_m - 0.025;
  })) << sight_.all().back().trunk_height_m;
}

TEST_F(EmulatorOnTheBus, ATrialEndsAndTheNextOneBeginsAnew) {
  sight_.tell_trial(1, 0.5);
  ASSERT_TRUE(sight_.first_of(1));
  ASSERT_TRUE(line_.power_all());
  const auto ended =
      sight_.await([](const auto& seen) { return seen.verdict != scarab_VERDICT_OPEN; });
  ASSERT_TRUE(ended);
  EXPECT_EQ(ended->verdict, scarab_VERDICT_SUCCESS);
  EXPECT_TRUE(sight_.await([&](const auto& seen) {
    return seen.header.tick > ended->header.tick && seen.verdict == scarab_VERDICT_SUCCESS;
  })) << "it stays told";

  sight_.tell_trial(2);
  const auto second = sight_.first_of(2);
  ASSERT_TRUE(second);
  EXPECT_EQ(second->header.tick, 0U);
  EXPECT_EQ(second->verdict, scarab_VERDICT_OPEN);
  EXPECT_TRUE(emulator_.notes(",trial,2"));
  // Its servos still have their torque; but somebody holds the robot until it is given anew.
  for (int i = 0; i < 50; ++i) ASSERT_TRUE(line_.ask(dxl::ping(1)));
  EXPECT_EQ(sight_.all().back().header.tick, 0U);
  ASSERT_TRUE(line_.write(1, model_.torque_enable, 1));
  EXPECT_TRUE(sight_.await(
      [](const auto& seen) { return seen.header.trial == 2 && seen.header.tick > 2; }));
}

TEST_F(EmulatorOnTheBus, APoseIsForTheNextTrial) {
  const auto before = line_.read(8, model_.present_position);
  emulator_.tell("pose CL1 -0.7");
  EXPECT_EQ(line_.read(8, model_.present_position), before);
  sight_.tell_trial(1);
  ASSERT_TRUE(sight_.first_of(1));
  EXPECT_GT(std::abs(*line_.read(8, model_.present_position) - *before), 150);
}

}  // namespace
}  // namespace scarab::test
