#include <gmock/gmock.h>

#include <cstdlib>

#include "common/bus/reader.hpp"
#include "common/bus/topics.hpp"
#include "common/bus/writer.hpp"
#include "tests/integration/bus/fixture.hpp"

namespace scarab::bus {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StrEq;
using testing::ThrowsMessage;

TEST(Faults, AMissingInterfaceIsNamed) {
  ParticipantOptions options = test_options("plant");
  options.interface = "eth7";
  EXPECT_THAT([&] { Participant plant(options); },
              ThrowsMessage<Error>(StrEq("interface eth7 not found")));
}

TEST(Faults, ADomainOutOfRangeIsNamed) {
  ParticipantOptions options = test_options("plant");
  options.domain = 231;
  EXPECT_THAT([&] { Participant plant(options); },
              ThrowsMessage<Error>(HasSubstr("domain 231 out of range")));
}

TEST(Faults, WhatCycloneSaysIsInTheError) {
  ASSERT_EQ(setenv("CYCLONEDDS_URI", "<CycloneDDS><Domain><Nonsense/></Domain></CycloneDDS>", 1),
            0);
  EXPECT_THAT([&] { Participant plant(test_options("plant")); },
              ThrowsMessage<Error>(AllOf(HasSubstr("participant plant/0 in domain 0"),
                                         HasSubstr("Nonsense: unknown element"))));
  unsetenv("CYCLONEDDS_URI");
}

TEST(Faults, AnotherTypeOnTheTopicIsReportedByBothSides) {
  constexpr Topic<scarab_JointCommand> kImpostor{kBehaviour.name, kBehaviour.profile};
  Participant supervisor(test_options("supervisor"));
  Participant premotor(test_options("premotor"));
  Writer<scarab_JointCommand> writer(supervisor, kImpostor);
  Reader<scarab_Behaviour> reader(premotor, kBehaviour);
  ASSERT_TRUE(eventually([&] { return !reader.faults().empty() && !writer.faults().empty(); }));
  EXPECT_THAT(reader.faults(), ElementsAre("inconsistent type on scarab/behaviour"));
  EXPECT_THAT(writer.faults(), ElementsAre("inconsistent type on scarab/behaviour"));
  EXPECT_TRUE(reader.matched().empty());
}

TEST(Faults, AnotherTypeInOneParticipantIsReportedToo) {
  constexpr Topic<scarab_JointCommand> kImpostor{kBehaviour.name, kBehaviour.profile};
  Participant supervisor(test_options("supervisor"));
  Writer<scarab_Behaviour> writer(supervisor, kBehaviour);
  Reader<scarab_JointCommand> reader(supervisor, kImpostor);
  ASSERT_TRUE(eventually([&] { return !reader.faults().empty() && !writer.faults().empty(); }));
  EXPECT_THAT(reader.faults(), ElementsAre("inconsistent type on scarab/behaviour"));
}

TEST(Faults, AnIncompatiblePolicyIsNamed) {
  constexpr Topic<scarab_Behaviour> kWatched{kBehaviour.name, Profile::kStatus};
  Participant supervisor(test_options("supervisor"));
  Participant premotor(test_options("premotor"));
  Writer<scarab_Behaviour> writer(supervisor, kBehaviour);
  Reader<scarab_Behaviour> reader(premotor, kWatched);
  ASSERT_TRUE(eventually([&] { return !reader.faults().empty() && !writer.faults().empty(); }));
  EXPECT_THAT(reader.faults(), ElementsAre("incompatible qos (liveliness) on scarab/behaviour"));
  EXPECT_THAT(writer.faults(), ElementsAre("incompatible qos (liveliness) on scarab/behaviour"));
}

}  // namespace
}  // namespace scarab::bus
