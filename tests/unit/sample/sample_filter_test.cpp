#include "common/sample/sample_filter.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <vector>

#include "common/bus/cdr.hpp"
#include "common/bus/sample_fields.hpp"
#include "common/bus/topic_type.hpp"
#include "common/bus/topics.hpp"
#include "common/sample/field_path.hpp"

namespace scarab::sample {
namespace {

using testing::StartsWith;

TypeRef make(decltype(Type::kind) kind) {
  return std::make_shared<const Type>(Type{std::move(kind)});
}

const TypeModel kBehaviourModel = bus::model_of(bus::descriptor<scarab_Behaviour>());

Bytes behaviour() {
  scarab_Behaviour sample{};
  sample.header.trial = 3;
  sample.header.tick = 100;
  sample.header.stamp_ns = std::numeric_limits<std::int64_t>::max() - 1;
  sample.real_time = true;
  sample.mode = scarab_MODE_HARD_PUSH;
  sample.inputs[2] = -0.1;
  sample.bs_rad = std::numeric_limits<double>::quiet_NaN();
  bus::assign(sample.reason, "BS over threshold, it's 0.35");
  return bus::encode(sample);
}

bool matches(const std::string& expression) {
  return SampleFilter(kBehaviourModel, expression).matches(behaviour());
}

std::string error_of(const std::string& expression) {
  try {
    SampleFilter(kBehaviourModel, expression);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(SampleFilter, ComparesNumbers) {
  EXPECT_TRUE(matches("header.tick = 100"));
  EXPECT_TRUE(matches("header.tick = 1e2"));
  EXPECT_TRUE(matches("header.tick = 0x64"));
  EXPECT_FALSE(matches("header.tick <> 100"));
  EXPECT_TRUE(matches("header.tick > 99.5"));
  EXPECT_FALSE(matches("header.tick > 100"));
  EXPECT_TRUE(matches("header.tick >= 100"));
  EXPECT_TRUE(matches("header.tick <= 100"));
  EXPECT_FALSE(matches("header.tick < 100"));
  EXPECT_TRUE(matches("inputs[2] = -0.1"));
  EXPECT_TRUE(matches("inputs[2]<-.05"));
  EXPECT_TRUE(matches("-1 < inputs[2]"));
  EXPECT_TRUE(matches("header.trial < header.tick"));
}

TEST(SampleFilter, ComparesLargeIntegersExactly) {
  EXPECT_TRUE(matches("header.stamp_ns = 9223372036854775806"));
  EXPECT_FALSE(matches("header.stamp_ns = 9223372036854775807"));
  EXPECT_TRUE(matches("header.stamp_ns < 18446744073709551615"));
}

TEST(SampleFilter, TreatsNanAsUnlikeEveryNumber) {
  EXPECT_FALSE(matches("bs_rad = 0"));
  EXPECT_FALSE(matches("bs_rad < 0 OR bs_rad >= 0"));
  EXPECT_TRUE(matches("bs_rad <> 0"));
}

TEST(SampleFilter, ComparesEnumsByNameAndTruthValues) {
  EXPECT_TRUE(matches("mode = 'MODE_HARD_PUSH'"));
  EXPECT_FALSE(matches("mode = 'MODE_STOP'"));
  EXPECT_TRUE(matches("mode > 'MODE_STOP'"));
  EXPECT_TRUE(matches("mode = 6"));
  EXPECT_TRUE(matches("real_time = TRUE"));
  EXPECT_TRUE(matches("hind_override = false"));
}

TEST(SampleFilter, ComparesText) {
  EXPECT_TRUE(matches("reason = 'BS over threshold, it''s 0.35'"));
  EXPECT_TRUE(matches("reason < 'BT'"));
  EXPECT_TRUE(matches("reason LIKE 'BS%'"));
  EXPECT_TRUE(matches("reason LIKE '%it''s ____'"));
  EXPECT_TRUE(matches("reason LIKE '%over%old%'"));
  EXPECT_TRUE(matches("reason like '%'"));
  EXPECT_FALSE(matches("reason LIKE 'bs%'"));
  EXPECT_FALSE(matches("reason LIKE '%over'"));
  EXPECT_FALSE(matches("reason LIKE '%it''s _____'"));
}

TEST(SampleFilter, JoinsWithTheStandardsPrecedence) {
  const std::string yes = "header.trial = 3";
  const std::string no = "header.trial = 4";
  EXPECT_TRUE(matches(yes + " OR " + yes + " AND " + no));
  EXPECT_FALSE(matches("(" + yes + " OR " + yes + ") AND " + no));
  EXPECT_TRUE(matches("NOT " + no + " AND " + yes));
  EXPECT_FALSE(matches("NOT (" + no + " OR " + yes + ")"));
  EXPECT_TRUE(matches("not not " + yes));
  EXPECT_TRUE(matches(no + " or " + no + " or " + yes));
}

TEST(SampleFilter, KnowsRanges) {
  EXPECT_TRUE(matches("header.tick BETWEEN 100 AND 200"));
  EXPECT_TRUE(matches("header.tick BETWEEN 0 AND 100"));
  EXPECT_FALSE(matches("header.tick BETWEEN 101 AND 200"));
  EXPECT_FALSE(matches("header.tick NOT BETWEEN 100 AND 200"));
  EXPECT_TRUE(matches("header.tick NOT BETWEEN 1 AND 2 AND header.trial = 3"));
  EXPECT_TRUE(matches("mode BETWEEN 'MODE_FORWARD' AND 'MODE_HARD_PUSH'"));
}

TEST(SampleFilter, FindsNothingInElementsThatAreNotThere) {
  const TypeModel model = bus::model_of(bus::descriptor<scarab_WorldState>());
  std::vector<scarab_Contact> contacts(1);
  scarab_WorldState state{};
  bus::borrow(state.contacts, contacts);
  const Bytes cdr = bus::encode(state);
  const auto holds = [&](const std::string& filter) {
    return SampleFilter(model, filter).matches(cdr);
  };
  EXPECT_TRUE(holds("contacts.length = 1"));
  EXPECT_TRUE(holds("contacts[0].depth_m = 0"));
  EXPECT_FALSE(holds("contacts[1].depth_m = 0"));
  EXPECT_FALSE(holds("contacts[1].depth_m <> 0"));
  EXPECT_FALSE(holds("contacts[1].depth_m NOT BETWEEN 1 AND 2"));
}

TEST(SampleFilter, RoundsNumbersAsTheFieldIsRounded) {
  const TypeModel model(make(StructType{
      "a::Small", {{"share", make(Primitive::kFloat)}, {"letter", make(Primitive::kChar)}}}));
  // 0.1f, 'x', little-endian.
  const Bytes cdr{std::byte{0},    std::byte{1},    std::byte{0},    std::byte{0},  std::byte{0xcd},
                  std::byte{0xcc}, std::byte{0xcc}, std::byte{0x3d}, std::byte{'x'}};
  EXPECT_TRUE(SampleFilter(model, "share = 0.1").matches(cdr));
  EXPECT_TRUE(SampleFilter(model, "letter = 'x'").matches(cdr));
  EXPECT_FALSE(SampleFilter(model, "letter = 'y'").matches(cdr));
}

TEST(SampleFilter, NamesColumnAndReason) {
  EXPECT_EQ(error_of(""), "column 1: a field or a value expected, but the end follows");
  EXPECT_EQ(error_of("header.tick == 3"), "column 13: equal is written =");
  EXPECT_EQ(error_of("mode = \"MODE_STOP\""), "column 8: text stands in single quotes");
  EXPECT_EQ(error_of("reason = 'open"), "column 10: text without its closing '");
  EXPECT_EQ(error_of("header.tick = 3 header"),
            "column 17: AND, OR or the end expected, but header follows");
  EXPECT_EQ(error_of("header.tick"),
            "column 12: one of = <> < <= > >= LIKE BETWEEN expected, but the end follows");
  EXPECT_EQ(error_of("(header.tick = 3"), "column 17: ) expected, but the end follows");
  EXPECT_EQ(error_of("header = 3"), "column 1: header is not one value; name a part of it");
  EXPECT_EQ(error_of("header.tik = 3"),
            "column 1: no member tik in scarab::Header; it has trial, tick, sim_time_ns, stamp_ns");
  EXPECT_EQ(error_of("1 = 1"), "column 1: a comparison needs a field");
  EXPECT_EQ(error_of("header.tick = 1x"), "column 15: 1x is no number");
  EXPECT_EQ(error_of("header.tick = %0"),
            "column 15: a parameter has no value here; write the value itself");
  EXPECT_EQ(error_of("header.tick BETWEEN 1 OR 2"),
            "column 23: AND of BETWEEN expected, but OR follows");
}

TEST(SampleFilter, RefusesComparisonsOfUnlikeKinds) {
  EXPECT_EQ(error_of("header.tick = 'ten'"),
            "column 15: header.tick is of type unsigned long: a number expected");
  EXPECT_EQ(error_of("reason = 3"),
            "column 10: reason is of type string<127>: text in single quotes expected");
  EXPECT_EQ(error_of("real_time = 1"),
            "column 13: real_time is of type boolean: TRUE or FALSE expected");
  EXPECT_EQ(error_of("mode = MODE_STOP"),
            "column 8: no member MODE_STOP in scarab::Behaviour; it has header, real_time, mode, "
            "inputs, hind_override, hind_pose_rad, backbone_rad, state, entered_tick, reason, "
            "bs_rad, bs_threshold_rad, as_rad, as_threshold_rad, trigger, trigger_value, "
            "trigger_threshold");
  EXPECT_THAT(error_of("mode = 'HARD'"),
              StartsWith("column 8: 'HARD' is no scarab::Mode; there are MODE_STOP, MODE_FORWARD"));
  EXPECT_EQ(error_of("mode = header.tick"),
            "column 8: header.tick is of type unsigned long, but mode is of type scarab::Mode");
  EXPECT_EQ(error_of("header.tick LIKE '1%'"),
            "column 18: header.tick is of type unsigned long: a number expected");
  EXPECT_EQ(error_of("mode LIKE 'MODE_STOP'"),
            "column 6: LIKE compares a text field with a pattern in quotes");
}

TEST(SampleFilter, BoundsItsNesting) {
  EXPECT_THAT(error_of(std::string(5000, '(')), StartsWith("column 101: nested too deeply"));
}

TEST(SampleFilter, SaysWhenBytesAreNoSample) {
  const SampleFilter filter(kBehaviourModel, "header.tick = 3");
  EXPECT_THROW(filter.matches(Bytes(6)), Error);
}

}  // namespace
}  // namespace scarab::sample
