#include <gmock/gmock.h>

#include <cstring>

#include "common/bus/cdr.hpp"
#include "common/bus/clock.hpp"
#include "common/bus/raw_reader.hpp"
#include "common/bus/reader.hpp"
#include "common/bus/sample_fields.hpp"
#include "common/bus/topics.hpp"
#include "common/bus/waitset.hpp"
#include "common/bus/writer.hpp"
#include "tests/integration/bus/fixture.hpp"

namespace scarab::bus {
namespace {

using std::chrono::seconds;

/// What a sample's pointers refer to.
struct Backing {
  std::string service = "premotor";
  std::vector<scarab_Counter> counters;
  std::vector<scarab_Histogram> histograms;
  std::vector<scarab_Contact> contacts;
};

// Every sample starts as memory full of 0xAA, so that padding is never zero by chance.
void complete(scarab_RobotState& s, Backing&) {
  s.real_time = true;
  s.phase = scarab_PHASE_SAFE_STOP;
  for (int i = 0; i < 19; ++i) {
    s.position_rad[i] = 0.1 * i;
    s.position_source[i] = scarab_SOURCE_MEASURED;
    s.velocity_source[i] = scarab_SOURCE_ABSENT;
    s.torque_source[i] = scarab_SOURCE_COMMANDED;
  }
  for (auto& source : s.foot_force_source) source = scarab_SOURCE_MEASURED;
  s.imu_source = scarab_SOURCE_MEASURED;
  s.motion_source = scarab_SOURCE_MEASURED;
  s.supply_current_source = scarab_SOURCE_MEASURED;
}

void complete(scarab_Behaviour& s, Backing&) {
  s.real_time = false;
  s.mode = scarab_MODE_SOFT_PUSH;
  s.hind_override = true;
  s.state = scarab_BEHAVIOUR_CLIMB;
  assign(s.reason, "the cylinder is reached");
  s.trigger = scarab_TRIGGER_SUPPLY_CURRENT;
}

void complete(scarab_JointCommand& s, Backing&) { s.kind = scarab_COMMAND_POSITION; }

void complete(scarab_NeuralActivity&, Backing&) {}

void complete(scarab_WorldState& s, Backing& backing) {
  s.obstacle_present = true;
  s.verdict = scarab_VERDICT_SUCCESS;
  assign(s.verdict_reason, "across");
  backing.contacts.resize(3);
  std::memset(backing.contacts.data(), 0xAA, 3 * sizeof(scarab_Contact));
  for (scarab_Contact& contact : backing.contacts) {
    contact.solid_a = scarab_SOLID_GROUND;
    contact.solid_b = scarab_SOLID_TIBIA;
  }
  borrow(s.contacts, backing.contacts);
}

void complete(scarab_Trial& s, Backing&) {
  assign(s.strategy, "soft+hard");
  s.goal = scarab_GOAL_ACROSS;
  s.perturb_cpg_phase = false;
}

void complete(scarab_ServiceStatus& s, Backing& backing) {
  borrow(s.service, backing.service);
  s.lifecycle = scarab_LIFECYCLE_ACTIVE;
  s.health = scarab_HEALTH_OK;
  assign(s.message, "");
  backing.counters.resize(2);
  assign(backing.counters[1].name, "clamped");
  borrow(s.counters, backing.counters);
  backing.histograms.resize(2);
  assign(backing.histograms[1].name, "command_age");
  backing.histograms[1].count[3] = 17;
  borrow(s.histograms, backing.histograms);
}

void complete(scarab_Operator& s, Backing&) {
  s.command = scarab_OPERATOR_STRATEGY;
  s.mode = scarab_MODE_STOP;
  assign(s.strategy, "soft+hard");
  assign(s.reason, "by hand");
}

template <class T>
void fill(T& sample, Backing& backing) {
  std::memset(static_cast<void*>(&sample), 0xAA, sizeof(T));
  complete(sample, backing);
}

template <class T>
class RawBytes : public testing::Test {};

using TopicTypes =
    testing::Types<scarab_RobotState, scarab_Behaviour, scarab_JointCommand, scarab_NeuralActivity,
                   scarab_WorldState, scarab_Trial, scarab_ServiceStatus, scarab_Operator>;
TYPED_TEST_SUITE(RawBytes, TopicTypes);

TYPED_TEST(RawBytes, WhatATypelessReaderTakesIsWhatEncodeGives) {
  ParticipantOptions options = test_options("plant");
  Participant plant(options);
  options.self = {"logger", 0};
  Participant logger(options);
  const Topic<TypeParam> topic{"test/raw", Profile::kState};
  Writer<TypeParam> writer(plant, topic);
  Discovery discovery(logger);
  std::vector<DiscoveredEndpoint> found;
  ASSERT_TRUE(eventually([&] {
    found = discovery.update();
    return !found.empty();
  }));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].topic, "test/raw");
  EXPECT_EQ(found[0].type, descriptor<TypeParam>().m_typename);
  EXPECT_EQ(found[0].peer, (Peer{"plant", 0}));
  RawReader reader(logger, found, discovery.type_of(found[0], seconds(10)));

  Backing backing;
  TypeParam sample;
  fill(sample, backing);
  const std::int64_t before = now_ns();
  writer.write(sample);
  WaitSet waitset(logger);
  waitset.attach(reader);
  ASSERT_TRUE(waitset.wait(seconds(10)));
  Bytes taken;
  const std::size_t count = reader.take([&](const RawSample& raw) {
    taken.assign(raw.cdr.data, raw.cdr.data + raw.cdr.size);
    EXPECT_GE(raw.source_ns, before);
    EXPECT_GE(raw.reception_ns, raw.source_ns);
    EXPECT_LE(raw.reception_ns, now_ns());
  });
  EXPECT_EQ(count, 1U);
  EXPECT_EQ(taken, encode(sample));
  EXPECT_EQ(encode(*decode<TypeParam>(taken)), taken);
}

}  // namespace
}  // namespace scarab::bus
