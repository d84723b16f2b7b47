#include "common/bus/topic_type.hpp"
#include "common/sample/idl_text.hpp"
#include "tests/integration/topic/topic_tool.hpp"

namespace scarab::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

using Type = TopicTool;

std::string idl_of(const dds_topic_descriptor_t& type) {
  return sample::idl_text(bus::model_of(type));
}

TEST_F(Type, PrintsTheIdlOfATopic) {
  const bus::Writer<scarab_WorldState> writer(plant_, bus::kWorldState);
  const Finished type = topic({"type", "scarab/world_state"});
  EXPECT_EQ(type.exit_code, 0) << type.err;
  EXPECT_EQ(type.out, idl_of(bus::descriptor<scarab_WorldState>()));
}

TEST_F(Type, KnowsTheTypeOfATopicThatIsOnlyRead) {
  const AnyReader reader(plant_, "a", bus::descriptor<scarab_Trial>());
  EXPECT_EQ(topic({"type", "a"}).out, idl_of(bus::descriptor<scarab_Trial>()));
}

TEST_F(Type, KnowsTypesByName) {
  EXPECT_EQ(topic({"type", "--name", "scarab::RobotState"}).out,
            idl_of(bus::descriptor<scarab_RobotState>()));
  expect_refused(5, {"type", "--name", "scarab::RobotStat", "--timeout", "0.3"},
                 "did you mean scarab::RobotState?");
  expect_refused(2, {"type"}, "a topic, or --name NAME is required");
  expect_refused(2, {"type", "a", "--name", "b"}, "excludes");
}

TEST_F(Type, SaysThatItIsUnknown) {
  const bus::RawWriter writer(
      plant_, "a", disguised(bus::descriptor<scarab_Operator>(), "far::Thing", false), kept());
  for (const char* verb : {"type", "fields", "echo", "hz", "wait"}) {
    expect_refused(5, {verb, "a"},
                   "type far::Thing of a: its writer sends no type information, and it is none of "
                   "Scarab's own");
  }
}

TEST_F(Type, ListsFields) {
  const Finished fields = topic({"fields", "--name", "scarab::WorldState"});
  EXPECT_EQ(fields.exit_code, 0) << fields.err;
  EXPECT_THAT(fields.out,
              AllOf(StartsWith("header.trial                unsigned long\n"),
                    HasSubstr("\ntrunk.orientation_wxyz      double[4]\n"),
                    HasSubstr("\ncontacts                    sequence<scarab::Contact, 96>\n"
                              "contacts.length             number of elements\n"
                              "contacts[0].solid_a         scarab::Solid\n")));
  EXPECT_THAT(topic({"fields", "--name", "scarab::Operator", "--names"}).out,
              StartsWith("header.trial\nheader.tick\nheader.sim_time_ns\nheader.stamp_ns\n"
                         "command\nmode\ninputs\n"));
}

}  // namespace
}  // namespace scarab::test
