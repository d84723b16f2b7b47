#include "common/bus/raw_qos.hpp"

#include <gmock/gmock.h>

#include "common/bus/compatibility.hpp"
#include "common/bus/error.hpp"

namespace scarab::bus {
namespace {

using std::chrono::milliseconds;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;
using testing::ThrowsMessage;

RawQos unusual() {
  RawQos qos;
  qos.reliability = DDS_RELIABILITY_BEST_EFFORT;
  qos.durability = DDS_DURABILITY_TRANSIENT_LOCAL;
  qos.ownership = DDS_OWNERSHIP_EXCLUSIVE;
  qos.ownership_strength = -7;
  qos.liveliness = DDS_LIVELINESS_MANUAL_BY_TOPIC;
  qos.liveliness_lease = milliseconds(250);
  qos.deadline = milliseconds(20);
  qos.history_depth = 0;
  qos.partitions = {"left leg", "", "right,leg"};
  qos.xcdr2 = true;
  return qos;
}

TEST(RawQos, SurvivesItsWords) {
  EXPECT_EQ(raw_qos_from_words(to_words(RawQos{})), RawQos{});
  EXPECT_EQ(raw_qos_from_words(to_words(unusual())), unusual());
  EXPECT_FALSE(unusual() == RawQos{});
}

TEST(RawQos, IsWrittenInTheWordsOfTheStandard) {
  const auto words = to_words(unusual());
  EXPECT_THAT(words, Contains(Pair("reliability", "best-effort")));
  EXPECT_THAT(words, Contains(Pair("durability", "transient-local")));
  EXPECT_THAT(words, Contains(Pair("history", "all")));
  EXPECT_THAT(words, Contains(Pair("lease_ns", "250000000")));
  EXPECT_THAT(words, Contains(Pair("partition.2", "right,leg")));
}

TEST(RawQos, AbsentWordsMeanTheDefault) {
  EXPECT_EQ(raw_qos_from_words({}), RawQos{});
  EXPECT_EQ(raw_qos_from_words({{"of_a_later_version", "x"}}), RawQos{});
}

TEST(RawQos, AWordThatIsNoneIsRefusedByName) {
  const std::pair<const char*, const char*> bad[] = {
      {"reliability", "mostly"}, {"durability", "transient"},     {"history", "0"},
      {"history", "9x"},         {"deadline_ns", "-1"},           {"representation", "xml"},
      {"liveliness", ""},        {"ownership_strength", "strong"}};
  for (const auto& [word, value] : bad) {
    const std::map<std::string, std::string> words{{word, value}};
    EXPECT_THAT([&] { raw_qos_from_words(words); }, ThrowsMessage<Error>(HasSubstr(word))) << value;
  }
}

TEST(RawQos, GoesThroughThePoliciesOfAnEntity) {
  RawQos qos = unusual();
  const Qos policies = dds_qos_of(qos);
  RawQos back = raw_qos_of(*policies);
  EXPECT_EQ(back.history_depth, RawQos{}.history_depth);  // is not announced
  back.history_depth = qos.history_depth;
  EXPECT_EQ(back, qos);
  EXPECT_THAT(mismatches(*policies, *policies), IsEmpty());
}

}  // namespace
}  // namespace scarab::bus
