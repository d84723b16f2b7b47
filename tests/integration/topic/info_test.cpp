#include "tests/integration/topic/topic_tool.hpp"

namespace scarab::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

using Info = TopicTool;

TEST_F(Info, TellsOfEveryEndpoint) {
  const bus::Writer<scarab_ServiceStatus> writer(plant_, bus::kServiceStatus);
  bus::Participant logger{test_options("logger", 2)};
  const AnyReader reader(logger, bus::kServiceStatus.name, bus::descriptor<scarab_ServiceStatus>());
  const Finished info = topic({"info", "scarab/service_status"});
  EXPECT_EQ(info.exit_code, 0) << info.err;
  const std::string here = "[" + std::to_string(getpid()) + "] on ";
  EXPECT_THAT(
      info.out,
      AllOf(HasSubstr("topic  scarab/service_status\ntype   scarab::ServiceStatus\n"
                      "1 writer, 1 reader\n"),
            HasSubstr("writer plant/0   integration_topic["), HasSubstr(here),
            HasSubstr(", Cyclone DDS\n"),
            HasSubstr("                 reliable, transient-local, liveliness 1 s\n"),
            HasSubstr("reader logger/2  "), HasSubstr("Every reader matches every writer.\n")));
}

TEST_F(Info, TellsWhatIsOfferedAndAsked) {
  bus::RawQos weak;
  weak.reliability = DDS_RELIABILITY_BEST_EFFORT;
  const AnyWriter writer(plant_, "a", bus::descriptor<scarab_Operator>(), weak);
  const AnyReader reader(plant_, "a", bus::descriptor<scarab_Operator>());
  const Finished info = topic({"info", "a"});
  EXPECT_THAT(info.out,
              AllOf(HasSubstr("! plant/0 gets nothing from plant/0: reliability: best-effort "
                              "offered, reliable asked\n"),
                    HasSubstr("! plant/0 gets nothing from plant/0: durability: volatile offered, "
                              "transient-local asked\n")));
  EXPECT_THAT(topic({"info", "a", "--json"}).out,
              HasSubstr("{\"policy\": \"reliability\", \"offered\": \"best-effort\", \"asked\": "
                        "\"reliable\", \"writer\": \"plant/0\", \"reader\": \"plant/0\"}"));
}

TEST_F(Info, TellsWhereTypesDiffer) {
  bus::Participant other{test_options("supervisor")};
  bus::Participant third{test_options("premotor")};
  const AnyWriter writer(plant_, "a", bus::descriptor<scarab_Operator>());
  const AnyReader reader(other, "a", bus::descriptor<scarab_Trial>());
  // Two versions of a type: the same name, not the same members.
  const bus::TopicType newer = disguised(bus::descriptor<scarab_Trial>(), "scarab::Operator", true);
  const AnyReader same_name(third, "a", *newer);
  const Finished info = topic({"info", "a"});
  EXPECT_THAT(info.out, AllOf(HasSubstr("type   scarab::Operator != scarab::Trial\n"),
                              HasSubstr("       type scarab::Trial\n"),
                              HasSubstr("! supervisor/0 gets nothing from plant/0: type name: "
                                        "scarab::Operator offered, scarab::Trial asked\n"),
                              HasSubstr("! premotor/0 gets nothing from plant/0: type: one with "
                                        "\"scarab::OperatorCommand command\" offered, one with "
                                        "\"scarab::GoalKind goal\" asked\n")));
}

TEST_F(Info, WantsATopicThatIsThere) {
  const bus::Writer<scarab_Trial> writer(plant_, bus::kTrial);
  expect_refused(4, {"info", "scarab/trail", "--timeout", "0.3"},
                 "no topic scarab/trail in domain 0; did you mean scarab/trial?");
  expect_refused(4, {"info", "x/y", "--timeout", "0.3"},
                 "no topic x/y in domain 0; there are scarab/trial");
  expect_refused(4, {"info", "x/y", "--timeout", "0.3", "--domain", "1"}, "it has none at all");
  expect_refused(2, {"info"}, "topic is required");
}

using Ps = TopicTool;

TEST_F(Ps, TellsWhoIsThere) {
  const bus::Writer<scarab_Trial> writer(plant_, bus::kTrial);
  const Finished ps = topic({"ps"});
  EXPECT_EQ(ps.exit_code, 0) << ps.err;
  EXPECT_THAT(ps.out, HasSubstr("SERVICE  PROGRAM"));
  EXPECT_THAT(ps.out,
              testing::ContainsRegex("\nplant/0  integration_top[a-z]*  *" +
                                     std::to_string(getpid()) + "  [^ ]*  *Cyclone DDS  *1  *0\n"));
  EXPECT_THAT(topic({"ps", "--json"}).out, AllOf(HasSubstr("[{\"service\": \"plant/0\", "),
                                                 HasSubstr("\"pid\": " + std::to_string(getpid())),
                                                 HasSubstr("\"writers\": 1, \"readers\": 0}]\n")));
}

}  // namespace
}  // namespace scarab::test
