#include "common/sample/cdr_builder.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "common/bus/cdr.hpp"
#include "common/bus/clock.hpp"
#include "common/bus/known_types.hpp"
#include "common/bus/sample_fields.hpp"
#include "common/bus/topic_type.hpp"
#include "common/bus/topics.hpp"
#include "common/sample/field_path.hpp"
#include "common/sample/sample_text.hpp"

namespace scarab::sample {
namespace {

using testing::HasSubstr;

using Kind = WrittenValue::Kind;

WrittenValue plain(const std::string& text) { return {Kind::kText, text, false, {}, {}}; }
WrittenValue quoted(const std::string& text) { return {Kind::kText, text, true, {}, {}}; }
WrittenValue list(std::vector<WrittenValue> items) {
  return {Kind::kList, "", false, {}, std::move(items)};
}
WrittenValue map(const std::vector<std::pair<std::string, WrittenValue>>& entries) {
  WrittenValue out{Kind::kMap, "", false, {}, {}};
  for (const auto& [key, item] : entries) {
    out.keys.push_back(key);
    out.items.push_back(item);
  }
  return out;
}

TypeRef make(decltype(Type::kind) kind) {
  return std::make_shared<const Type>(Type{std::move(kind)});
}

constexpr std::int64_t kNow = 1'700'000'000'123'456'789;

/// A struct with one member `x`.
TypeModel with_member(const TypeRef& type) {
  return TypeModel(make(StructType{"a::Thing", {{"x", type}}}));
}
TypeModel with_member(Primitive primitive) { return with_member(make(primitive)); }

std::string json_of(const TypeModel& model, const WrittenValue& x) {
  return json_text(model, build_cdr(model, map({{"x", x}}), kNow));
}

std::string error_of(const TypeModel& model, const WrittenValue& value) {
  try {
    build_cdr(model, value, kNow);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}
std::string member_error(const TypeModel& model, const WrittenValue& x) {
  return error_of(model, map({{"x", x}}));
}

struct EveryType : testing::TestWithParam<std::string> {};

TEST_P(EveryType, IsZeroWhereNothingIsSaid) {
  const dds_topic_descriptor_t& type = *bus::find_known_type(GetParam());
  std::vector<std::byte> zero(type.m_size);
  // Unbounded strings are pointers, which must not be null.
  const TypeModel model = bus::model_of(type);
  const Bytes built = build_cdr(model, {}, kNow);
  bus::decode_sample(type, built, zero.data());
  EXPECT_EQ(bus::encode_sample(type, zero.data()), built);
  dds_sample_free(zero.data(), &type, DDS_FREE_CONTENTS);
}

INSTANTIATE_TEST_SUITE_P(, EveryType, testing::ValuesIn(bus::known_type_names()),
                         [](const auto& of) { return of.param.substr(8); });

TEST(CdrBuilder, WritesTheBytesACompiledWriterWrites) {
  scarab_Contact contact{};
  contact.solid_b = scarab_SOLID_FOOT;
  contact.leg_b = 4;
  contact.force_n[2] = -1.5;
  std::vector<scarab_Contact> contacts{contact, contact};
  scarab_WorldState state{};
  state.header.tick = 7;
  state.trunk.position_m[1] = 0.1;
  state.obstacle_present = true;
  bus::borrow(state.contacts, contacts);
  bus::assign(state.verdict_reason, "over: the wall");

  const WrittenValue written = map({{"solid_b", plain("SOLID_FOOT")},
                                    {"leg_b", plain("4")},
                                    {"force_n", list({plain("0"), plain("0.0"), plain("-1.5")})}});
  const WrittenValue value =
      map({{"verdict_reason", quoted("over: the wall")},
           {"header", map({{"tick", plain("7")}})},
           {"trunk", map({{"position_m", list({plain("0"), plain("1e-1"), plain("0")})}})},
           {"obstacle_present", plain("true")},
           {"contacts", list({written, written})}});
  EXPECT_EQ(build_cdr(bus::model_of(bus::descriptor<scarab_WorldState>()), value, kNow),
            bus::encode(state));
}

TEST(CdrBuilder, WritesTypesThatMayGrowInXcdr2) {
  const TypeRef step = make(StructType{
      "Step",
      {{"leg", make(Primitive::kInt16), false}, {"height", make(Primitive::kDouble), false}},
      Extensibility::kAppendable});
  const TypeModel model(make(StructType{"T",
                                        {{"id", make(Primitive::kOctet), true},
                                         {"steps", make(SequenceType{step, 0}), false},
                                         {"last", make(Primitive::kInt64), false}}}));
  const WrittenValue value =
      map({{"id", plain("7")},
           {"steps", list({map({{"leg", plain("-1")}, {"height", plain("1.5")}})})},
           {"last", plain("5")}});
  // The rules of DDS-XTypes 1.3, 7.4.3: lengths before the sequence and the step, doubles and
  // 64-bit integers aligned to 4.
  const int expected[] = {0,    7,    0, 0,                     // PLAIN_CDR2: T itself is final
                          7,    0,    0, 0, 20, 0, 0,    0,     // id; bytes of steps
                          1,    0,    0, 0, 12, 0, 0,    0,     // their number; bytes of the first
                          0xFF, 0xFF, 0, 0,                     // leg
                          0,    0,    0, 0, 0,  0, 0xF8, 0x3F,  // height
                          5,    0,    0, 0, 0,  0, 0,    0};    // last
  Bytes bytes;
  for (const int byte : expected) bytes.push_back(static_cast<std::byte>(byte));
  EXPECT_EQ(build_cdr(model, value, kNow), bytes);
  EXPECT_EQ(json_text(model, bytes),
            R"({"id": 7, "steps": [{"leg": -1, "height": 1.5}], "last": 5})");
}

TEST(CdrBuilder, TakesIntegersOfTheirRangeOnly) {
  const TypeModel octet = with_member(Primitive::kOctet);
  EXPECT_EQ(json_of(octet, plain("255")), "{\"x\": 255}");
  EXPECT_EQ(member_error(octet, plain("256")), "x: 256 is no octet (0 to 255)");
  EXPECT_EQ(member_error(octet, plain("-1")), "x: -1 is no octet (0 to 255)");
  const TypeModel small = with_member(Primitive::kInt16);
  EXPECT_EQ(json_of(small, plain("-32768")), "{\"x\": -32768}");
  EXPECT_EQ(member_error(small, plain("32768")), "x: 32768 is no short (-32768 to 32767)");
  const TypeModel natural = with_member(Primitive::kUint64);
  EXPECT_EQ(json_of(natural, plain("18446744073709551615")), "{\"x\": 18446744073709551615}");
  EXPECT_EQ(json_of(natural, plain("0xff")), "{\"x\": 255}");
  EXPECT_THAT(member_error(natural, plain("18446744073709551616")), HasSubstr("is no unsigned"));
  EXPECT_EQ(json_of(with_member(Primitive::kInt64), plain("-9223372036854775808")),
            "{\"x\": -9223372036854775808}");
  EXPECT_THAT(member_error(natural, plain("1.0")), HasSubstr("x: 1.0 is no unsigned long long"));
  EXPECT_THAT(member_error(natural, plain("")), HasSubstr("is no"));
  EXPECT_THAT(member_error(natural, quoted("1")), HasSubstr("x: '1' is no"));
  EXPECT_THAT(member_error(natural, list({})), HasSubstr("x: a list is no"));
}

TEST(CdrBuilder, TakesNumbersAsTextHasThem) {
  const TypeModel number = with_member(Primitive::kDouble);
  for (const char* text : {"0.1", "-1e-300", "12345678.9", "5"}) {
    EXPECT_EQ(std::stod(json_of(number, plain(text)).substr(6)), std::stod(text));
  }
  // As json_text() writes them.
  for (const char* text : {"nan", "inf", "-inf"}) {
    EXPECT_EQ(json_of(number, quoted(text)), "{\"x\": \"" + std::string(text) + "\"}");
    EXPECT_EQ(json_of(number, plain(text)), json_of(number, quoted(text)));
  }
  EXPECT_EQ(json_of(number, plain("-.inf")), "{\"x\": \"-inf\"}");
  EXPECT_EQ(member_error(number, plain("1.2.3")), "x: 1.2.3 is no number");
  EXPECT_EQ(member_error(number, plain("infinite")), "x: infinite is no number");
  EXPECT_EQ(member_error(number, plain("1e999")), "x: 1e999 is beyond a double");
  EXPECT_EQ(member_error(with_member(Primitive::kFloat), plain("1e39")),
            "x: 1e39 is beyond a float");
}

TEST(CdrBuilder, TakesTruthCharactersAndText) {
  EXPECT_EQ(json_of(with_member(Primitive::kBoolean), plain("true")), "{\"x\": true}");
  EXPECT_EQ(member_error(with_member(Primitive::kBoolean), plain("yes")),
            "x: yes is neither true nor false");
  EXPECT_EQ(member_error(with_member(Primitive::kBoolean), quoted("true")),
            "x: 'true' is neither true nor false");
  EXPECT_EQ(json_of(with_member(Primitive::kChar), plain("z")), "{\"x\": \"z\"}");
  EXPECT_EQ(member_error(with_member(Primitive::kChar), plain("zz")),
            "x: zz is no single character of 8 bits");
  const TypeModel text = with_member(make(StringType{5}));
  EXPECT_EQ(json_of(text, plain("12")), "{\"x\": \"12\"}");
  EXPECT_EQ(member_error(text, quoted("sixsix")), "x: text of 6 bytes, at most 5");
  EXPECT_EQ(member_error(text, quoted(std::string("a\0b", 3))), "x: text with a zero in it");
  EXPECT_EQ(member_error(text, map({})), "x: text expected");
}

TEST(CdrBuilder, TakesEnumValuesByNameOrNumber) {
  const TypeModel model = with_member(make(EnumType{"a::Colour", {{"RED", 3}, {"GREEN", 7}}}));
  EXPECT_EQ(json_of(model, plain("GREEN")), "{\"x\": \"GREEN\"}");
  EXPECT_EQ(json_of(model, quoted("GREEN")), "{\"x\": \"GREEN\"}");
  EXPECT_EQ(json_of(model, plain("7")), "{\"x\": \"GREEN\"}");
  EXPECT_EQ(json_of(model, {}), "{\"x\": \"RED\"}") << "0 is none of its values";
  EXPECT_EQ(member_error(model, plain("BLUE")), "x: BLUE is no a::Colour; there are RED, GREEN");
  EXPECT_EQ(member_error(model, plain("4")), "x: 4 is no a::Colour; there are RED, GREEN");
}

TEST(CdrBuilder, ChecksTheLengthOfLists) {
  const TypeRef number = make(Primitive::kInt32);
  const TypeModel matrix = with_member(make(ArrayType{number, {2, 2}}));
  const WrittenValue row = list({plain("1"), plain("2")});
  EXPECT_EQ(json_of(matrix, list({row, {}})), "{\"x\": [[1, 2], [0, 0]]}");
  EXPECT_EQ(member_error(matrix, list({row})), "x: 1 elements, but it has 2");
  EXPECT_EQ(member_error(matrix, list({row, list({plain("1")})})),
            "x[1]: 1 elements, but it has 2");
  EXPECT_THAT(member_error(matrix, list({row, list({plain("1"), plain("a")})})),
              HasSubstr("x[1][1]: a is no long"));
  EXPECT_EQ(member_error(matrix, plain("3")), "x: a list expected");
  const TypeModel sequence = with_member(make(SequenceType{make(StringType{}), 2}));
  EXPECT_EQ(json_of(sequence, list({plain("a"), plain("bc")})), "{\"x\": [\"a\", \"bc\"]}");
  EXPECT_EQ(member_error(sequence, list({{}, {}, {}})), "x: 3 elements, at most 2");
}

TEST(CdrBuilder, RefusesNamesTheTypeDoesNotHave) {
  const TypeModel model = bus::model_of(bus::descriptor<scarab_JointCommand>());
  EXPECT_EQ(error_of(model, map({{"kinnd", plain("COMMAND_STOP")}})),
            "no member kinnd in scarab::JointCommand; it has header, kind, position_rad");
  EXPECT_EQ(error_of(model, map({{"header", map({{"tik", plain("1")}})}})),
            "header: no member tik in scarab::Header; it has trial, tick, sim_time_ns, stamp_ns");
  EXPECT_THROW(build_cdr(model, map({{"header", map({{"tik", plain("1")}})}}), kNow), NoSuchMember);
  EXPECT_EQ(error_of(model, map({{"kind", {}}, {"kind", {}}})), "kind is given twice");
  EXPECT_EQ(error_of(model, plain("3")), "a map of the members of scarab::JointCommand expected");
  EXPECT_EQ(error_of(model, map({{"header", list({})}})),
            "header: a map of the members of scarab::Header expected");
}

TEST(CdrBuilder, PutsInTheTimeForNow) {
  EXPECT_EQ(json_of(with_member(Primitive::kInt64), plain("now")), R"({"x": 1700000000123456789})");
  EXPECT_EQ(json_of(with_member(Primitive::kUint64), plain("now")),
            R"({"x": 1700000000123456789})");
  const TypeModel ros = with_member(make(StructType{
      "b::Time", {{"sec", make(Primitive::kInt32)}, {"nanosec", make(Primitive::kUint32)}}}));
  EXPECT_EQ(json_of(ros, plain("now")), R"({"x": {"sec": 1700000000, "nanosec": 123456789}})");
  EXPECT_THAT(member_error(with_member(Primitive::kInt32), plain("now")),
              HasSubstr("x: now is no long"));
}

}  // namespace
}  // namespace scarab::sample
