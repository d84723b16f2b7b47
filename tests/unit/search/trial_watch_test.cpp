#include "tools/search/trial_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "common/bus/sample_fields.hpp"

namespace scarab::search {
namespace {

/// A world that a test moves about.
struct World {
  scarab_WorldState state{};
  std::vector<scarab_Contact> contacts;

  World() {
    state.trunk.orientation_wxyz[0] = 1;
    state.object.position_m[0] = -0.5;
    state.object.position_m[2] = 0.09;
    state.obstacle_x_m = -1.4;
  }
  World& at(double time_s) {
    state.header.sim_time_ns = static_cast<std::int64_t>(std::llround(time_s * 1e9));
    return *this;
  }
  World& travel(double way_m) {
    state.object_travel_m = way_m;
    state.object.position_m[0] = -0.5 - way_m;
    return *this;
  }
  World& yaw(double angle_rad) {
    state.trunk.orientation_wxyz[0] = std::cos(angle_rad / 2);
    state.trunk.orientation_wxyz[3] = std::sin(angle_rad / 2);
    return *this;
  }
  World& contact(scarab_Solid a, scarab_Solid b, double up_n) {
    scarab_Contact contact{};
    contact.solid_a = a;
    contact.solid_b = b;
    contact.force_n[2] = up_n;
    contacts.push_back(contact);
    return *this;
  }
  const scarab_WorldState& sample() {
    state.contacts._buffer = contacts.data();
    state.contacts._length = static_cast<std::uint32_t>(contacts.size());
    return state;
  }
};

plant::PlantConfig plant_config() {
  plant::PlantConfig plant;
  plant.gravity_m_s2 = 10;
  plant.object.mass_kg = 2;
  plant.referee.across_margin_m = 0.1;
  return plant;
}

Scenario wall() {
  Scenario scenario;
  scenario.goal = Goal::kAcross;
  scenario.height_m = 0.1;
  return scenario;
}

TEST(TrialWatch, MeasuresTheWayToTheFarSideOfTheWall) {
  TrialWatch watch(wall(), plant_config(), 10);
  watch.see(World().sample());
  EXPECT_EQ(watch.measure().progress, 0);
  watch.see(World().travel(0.5).sample());
  EXPECT_DOUBLE_EQ(watch.measure().progress, 0.5) << "of 1.0 m to 0.1 m behind the wall";
  watch.see(World().travel(0.3).sample());
  EXPECT_DOUBLE_EQ(watch.measure().progress, 0.5) << "the most of the trial";
}

TEST(TrialWatch, MeasuresTheRiseOfTheAxis) {
  TrialWatch watch(wall(), plant_config(), 10);
  World world;
  watch.see(world.sample());
  world.state.object.position_m[2] += 0.04;
  watch.see(world.sample());
  EXPECT_NEAR(watch.measure().lift, 0.4, 1e-12);
}

TEST(TrialWatch, UnwrapsTheHeading) {
  TrialWatch watch(wall(), plant_config(), 10);
  watch.see(World().yaw(3.0).sample());
  watch.see(World().yaw(3.3).sample());
  watch.see(World().yaw(2.9).sample());
  EXPECT_NEAR(watch.measure().heading_max_rad, 0.3, 1e-9);
}

TEST(TrialWatch, CountsSamplesInWhichLegsTouch) {
  TrialWatch watch(wall(), plant_config(), 10);
  watch.see(World().contact(scarab_SOLID_GROUND, scarab_SOLID_FOOT, 8).sample());
  watch.see(World().contact(scarab_SOLID_TIBIA, scarab_SOLID_FOOT, 1).sample());
  EXPECT_DOUBLE_EQ(watch.measure().leg_leg_share, 0.5);
}

TEST(TrialWatch, MeasuresWhatTheSmoothPartsCarryWhicheverWayTheContactIsSaid) {
  TrialWatch watch(wall(), plant_config(), 10);
  watch.see(World().contact(scarab_SOLID_TRUNK, scarab_SOLID_OBJECT, 10).sample());
  watch.see(World().contact(scarab_SOLID_OBJECT, scarab_SOLID_FEMUR, -10).sample());
  watch.see(World().contact(scarab_SOLID_FOOT, scarab_SOLID_OBJECT, 10).sample());
  watch.see(World().contact(scarab_SOLID_TRUNK, scarab_SOLID_OBJECT, -10).sample());
  EXPECT_DOUBLE_EQ(watch.measure().carry_share, 0.25) << "half the weight in two of four";
}

TEST(TrialWatch, LooksAtThePitchUntilTheObjectIsTouched) {
  TrialWatch watch(wall(), plant_config(), 10);
  scarab_Behaviour behaviour{};
  behaviour.state = scarab_BEHAVIOUR_APPROACH;
  behaviour.bs_rad = -0.03;
  watch.see(World().sample());
  watch.see(behaviour);
  watch.see(World().contact(scarab_SOLID_FOOT, scarab_SOLID_OBJECT, 1).sample());
  behaviour.bs_rad = 0.14;
  watch.see(behaviour);
  EXPECT_EQ(watch.measure().approach_pitch_rad, 0.03);
}

TEST(TrialWatch, IsStuckOnceNothingHasMovedForLong) {
  TrialWatch watch(wall(), plant_config(), 10);
  watch.see(World().sample());
  watch.see(World().at(8).travel(0.1).sample());
  watch.see(World().at(17).travel(0.105).sample());
  EXPECT_FALSE(watch.stuck());
  watch.see(World().at(18.5).travel(0.105).sample());
  EXPECT_TRUE(watch.stuck());
  EXPECT_FALSE(watch.measure().success);
  EXPECT_FALSE(watch.measure().reason.empty());
}

TEST(TrialWatch, TakesTheVerdictOfTheReferee) {
  TrialWatch watch(wall(), plant_config(), 10);
  World world;
  watch.see(world.sample());
  world.at(12.34).travel(1.1).state.verdict = scarab_VERDICT_SUCCESS;
  world.state.verdict_time_s = 12.3;
  bus::assign(world.state.verdict_reason, "across");
  watch.see(world.sample());
  EXPECT_TRUE(watch.measure().success);
  EXPECT_EQ(watch.measure().time_s, 12.3);
  EXPECT_EQ(watch.measure().reason, "across");
}

}  // namespace
}  // namespace scarab::search
