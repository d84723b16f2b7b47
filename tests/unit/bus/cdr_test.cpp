#include "common/bus/cdr.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "common/bus/error.hpp"
#include "common/bus/sample_fields.hpp"
#include "common/bus/topic_type.hpp"
#include "common/sample/sample_columns.hpp"
#include "common/sample/sample_text.hpp"

namespace scarab::bus {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

sample::TypeRef make(decltype(sample::Type::kind) kind) {
  return std::make_shared<const sample::Type>(sample::Type{std::move(kind)});
}

Bytes bytes(std::initializer_list<int> values) {
  Bytes out;
  for (const int value : values) out.push_back(static_cast<std::byte>(value));
  return out;
}

struct World : testing::Test {
  std::vector<scarab_Contact> contacts{2};
  scarab_WorldState sample{};
  sample::TypeModel model = bus::model_of(descriptor<scarab_WorldState>());

  World() {
    sample.header.tick = 7;
    sample.trunk.position_m[2] = 0.125;
    sample.verdict = scarab_VERDICT_SUCCESS;
    contacts[1].solid_a = scarab_SOLID_FOOT;
    contacts[1].force_n[2] = -1.5;
    assign(sample.verdict_reason, "\"across\"\n");
    borrow(sample.contacts, contacts);
  }
};

TEST_F(World, SurvivesTheRoundTrip) {
  const Bytes cdr = encode(sample);
  EXPECT_EQ(cdr.size() % 4, 0U);
  const auto back = decode<scarab_WorldState>(cdr);
  EXPECT_EQ(back->header.tick, 7U);
  EXPECT_EQ(back->trunk.position_m[2], 0.125);
  ASSERT_EQ(elements(back->contacts).size(), 2U);
  EXPECT_EQ(elements(back->contacts)[1].force_n[2], -1.5);
  EXPECT_EQ(text(back->verdict_reason), "\"across\"\n");
  EXPECT_EQ(encode(*back), cdr);
}

TEST_F(World, CutAnywhereIsAnErrorForEveryDecoder) {
  const Bytes cdr = encode(sample);
  // The last bytes may be padding, so that the cut ends well before them.
  for (std::size_t size = 0; size + 8 < cdr.size(); ++size) {
    const ByteView cut{cdr.data(), size};
    EXPECT_THROW(decode<scarab_WorldState>(cut), Error) << size;
    EXPECT_THROW(sample::json_text(model, cut), Error) << size;
  }
}

TEST_F(World, FlippedBytesNeverCrash) {
  const Bytes cdr = encode(sample);
  for (std::size_t i = 0; i < cdr.size(); ++i) {
    Bytes wrong = cdr;
    wrong[i] ^= std::byte{0xFF};
    try {
      sample::column_values(model, wrong, {3});
      decode<scarab_WorldState>(wrong);
    } catch (const Error&) {
      continue;  // refused, which is as good
    }
  }
}

TEST_F(World, ColumnsHaveNamesAndValuesInStep) {
  for (const std::size_t shown : {0U, 1U, 3U, 200U}) {
    const auto names = sample::column_names(model, {shown});
    const auto values = sample::column_values(model, encode(sample), {shown});
    ASSERT_EQ(names.size(), values.size());
    const auto value = [&](const std::string& name) {
      const auto at = std::find(names.begin(), names.end(), name);
      return at == names.end() ? "no column" : values[static_cast<std::size_t>(at - names.begin())];
    };
    EXPECT_EQ(value("header.tick"), "7");
    EXPECT_EQ(value("trunk.position_m[2]"), "0.125");
    EXPECT_EQ(value("verdict"), "VERDICT_SUCCESS");
    EXPECT_EQ(value("contacts.length"), "2");
    EXPECT_EQ(value("contacts[1].force_n[2]"), shown > 1 ? "-1.5" : "no column");
    EXPECT_EQ(value("contacts[2].solid_a"), shown > 2 ? "" : "no column");
    EXPECT_EQ(value("contacts[95].solid_a"), shown > 95 ? "" : "no column");
    EXPECT_EQ(value("contacts[96].solid_a"), "no column");
  }
}

TEST_F(World, IsPrintedAsYamlAndJson) {
  const Bytes cdr = encode(sample);
  const std::string yaml = sample::yaml_text(model, cdr);
  EXPECT_THAT(yaml, HasSubstr("trunk:\n  position_m: [0, 0, 0.125]\n"));
  EXPECT_THAT(yaml, HasSubstr("contacts:\n  - solid_a: SOLID_GROUND\n    leg_a: 0\n"));
  EXPECT_THAT(yaml, HasSubstr("verdict_reason: \"\\\"across\\\"\\u000a\"\n"));
  const std::string json = sample::json_text(model, cdr);
  EXPECT_EQ(json.find('\n'), std::string::npos);
  EXPECT_THAT(json, HasSubstr(R"("verdict": "VERDICT_SUCCESS")"));
}

TEST(Encode, RefusesAValueThatItsEnumDoesNotHave) {
  scarab_JointCommand command{};
  std::memset(&command.kind, 2, sizeof(command.kind));
  EXPECT_THAT([&] { encode(command); }, ThrowsMessage<Error>(HasSubstr("scarab::JointCommand")));
}

TEST(Cdr, IsReadInBothByteOrders) {
  const sample::TypeModel model(
      make(sample::StructType{"T",
                              {{"flag", make(sample::Primitive::kBoolean), false},
                               {"number", make(sample::Primitive::kInt32), false},
                               {"text", make(sample::StringType{}), false},
                               {"real", make(sample::Primitive::kDouble), false}}}));
  const Bytes little = bytes({0, 1, 0,   0, 1, 0, 0, 0, 0xFE, 0xFF, 0xFF, 0xFF, 2,    0,
                              0, 0, 'a', 0, 0, 0, 0, 0, 0,    0,    0,    0,    0xF8, 0x3F});
  const Bytes big = bytes({0, 0, 0,   0, 1, 0, 0,    0,    0xFF, 0xFF, 0xFF, 0xFE, 0, 0,
                           0, 2, 'a', 0, 0, 0, 0x3F, 0xF8, 0,    0,    0,    0,    0, 0});
  EXPECT_EQ(sample::json_text(model, little),
            R"({"flag": true, "number": -2, "text": "a", "real": 1.5})");
  EXPECT_EQ(sample::json_text(model, big), sample::json_text(model, little));
}

/// A type that may grow, in the bytes that DDS-XTypes 1.3, 7.4.3 gives it in XCDR2.
struct Growing : testing::Test {
  const sample::TypeRef step =
      make(sample::StructType{"Step",
                              {{"leg", make(sample::Primitive::kInt16), false},
                               {"height", make(sample::Primitive::kDouble), false}},
                              sample::Extensibility::kAppendable});
  const sample::TypeModel model{
      make(sample::StructType{"T",
                              {{"id", make(sample::Primitive::kOctet), true},
                               {"steps", make(sample::SequenceType{step, 0}), false},
                               {"last", make(sample::Primitive::kInt64), false}},
                              sample::Extensibility::kAppendable})};
  // clang-format off
  const Bytes cdr = bytes({
      0, 9, 0, 0,                // DELIMIT_CDR2, little-endian
      56, 0, 0, 0,               // bytes of T
      7, 0, 0, 0,                // id; padding
      36, 0, 0, 0,               // bytes of steps
      2, 0, 0, 0,                // their number
      12, 0, 0, 0,               // bytes of the first
      0xFF, 0xFF, 0, 0,          // leg; doubles are aligned to 4
      0, 0, 0, 0, 0, 0, 0xF8, 0x3F,
      12, 0, 0, 0,
      2, 0, 0, 0,
      0, 0, 0, 0, 0, 0, 0, 0x40,
      5, 0, 0, 0, 0, 0, 0, 0,    // last
      1, 2, 3, 4});              // of a member that a newer version of T has
  // clang-format on
  const std::string json =
      R"({"id": 7, "steps": [{"leg": -1, "height": 1.5}, {"leg": 2, "height": 2}], "last": 5})";
};

TEST_F(Growing, IsReadFromXcdr2WithWhatANewerVersionAdds) {
  EXPECT_EQ(sample::json_text(model, cdr), json);
}

TEST_F(Growing, IsRefusedWhenCutAnywhere) {
  for (std::size_t size = 0; size < cdr.size(); ++size) {
    EXPECT_THROW(sample::json_text(model, {cdr.data(), size}), Error) << size;
  }
}

TEST_F(Growing, NeverReadsBeyondAPartsOwnLength) {
  Bytes short_step = cdr;
  short_step[20] = std::byte{8};  // ends within its height
  EXPECT_THAT([&] { sample::json_text(model, short_step); },
              ThrowsMessage<Error>(HasSubstr("T: the bytes end early")));
  Bytes long_step = cdr;
  long_step[20] = std::byte{36};  // reaches beyond the steps
  EXPECT_THAT([&] { sample::json_text(model, long_step); },
              ThrowsMessage<Error>(HasSubstr("T: the bytes end early")));
}

TEST(Cdr, NoArrayIsLargerThanItsSample) {
  const sample::TypeModel model(make(sample::StructType{
      "T",
      {{"a", make(sample::ArrayType{make(sample::Primitive::kOctet), {4'000'000'000U}}), false}}}));
  EXPECT_THAT(
      [&] {
        sample::json_text(model, bytes({0, 1, 0, 0, 1, 2, 3, 4}));
      },
      ThrowsMessage<Error>(HasSubstr("T: the bytes end early")));
  EXPECT_THAT([&] { sample::column_names(model); },
              ThrowsMessage<Error>(HasSubstr("too many columns")));
}

TEST(Cdr, AnotherRepresentationIsRefusedByName) {
  const sample::TypeModel model = bus::model_of(descriptor<scarab_Operator>());
  Bytes cdr = encode(scarab_Operator{});
  cdr[1] = std::byte{3};  // a parameter list
  EXPECT_THAT([&] { sample::json_text(model, cdr); },
              ThrowsMessage<Error>(HasSubstr("scarab::Operator: representation")));
}

TEST(ScalarText, IsTheShortestThatReadsBackTheSame) {
  for (const double value : {0.1, 1.0 / 3.0, -1e300, 5e-324, 123456789.0}) {
    EXPECT_EQ(std::strtod(sample::scalar_text(value).c_str(), nullptr), value);
  }
  EXPECT_EQ(sample::scalar_text(0.1), "0.1");
  const sample::TypeModel model(
      make(sample::StructType{"T", {{"x", make(sample::Primitive::kFloat), false}}}));
  const Bytes nan = bytes({0, 1, 0, 0, 0, 0, 0xC0, 0x7F});
  EXPECT_EQ(sample::json_text(model, nan), R"({"x": "nan"})");
}

}  // namespace
}  // namespace scarab::bus
