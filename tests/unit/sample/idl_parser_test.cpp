#include "common/sample/idl_parser.hpp"

#include <gmock/gmock.h>

#include <random>

#include "common/bus/error.hpp"
#include "common/bus/known_types.hpp"
#include "common/bus/topic_type.hpp"
#include "common/sample/idl_text.hpp"
#include "tests/unit/sample/same_type.hpp"

namespace scarab::sample {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using testing::ThrowsMessage;

TypeRef make(decltype(Type::kind) kind) {
  return std::make_shared<const Type>(Type{std::move(kind)});
}

TypeModel known(const std::string& name) { return bus::model_of(*bus::find_known_type(name)); }

struct ParsedKnownType : testing::TestWithParam<std::string> {};

TEST_P(ParsedKnownType, IsWhatItsTextWasMadeOf) {
  const TypeModel model = known(GetParam());
  const TypeModel parsed = parse_idl(idl_text(model), GetParam());
  EXPECT_TRUE(same_type(*parsed.type(), *model.type())) << idl_text(parsed);
}

INSTANTIATE_TEST_SUITE_P(, ParsedKnownType, testing::ValuesIn(bus::known_type_names()),
                         [](const auto& type) { return type.param.substr(8); });

/// Every construct that idl_text() writes.
TypeModel everything() {
  const TypeRef colour = make(EnumType{"a::Colour", {{"RED", -1}, {"GREEN", 7}, {"BLUE", 8}}});
  const TypeRef matrix =
      make(AliasType{"a::b::Matrix", make(ArrayType{make(Primitive::kDouble), {2, 3}})});
  const TypeRef point = make(
      StructType{"a::Point",
                 {{"x", make(Primitive::kFloat), false}, {"y", make(Primitive::kFloat), false}},
                 Extensibility::kAppendable});
  const TypeRef words = make(SequenceType{make(StringType{12}), 0});
  StructType all{"a::b::Everything", {{"id", make(Primitive::kInt16), true}}};
  for (const Primitive kind :
       {Primitive::kBoolean, Primitive::kOctet, Primitive::kChar, Primitive::kInt8,
        Primitive::kInt16, Primitive::kInt32, Primitive::kInt64, Primitive::kUint16,
        Primitive::kUint32, Primitive::kUint64, Primitive::kFloat, Primitive::kDouble}) {
    all.members.push_back({"plain_" + std::to_string(static_cast<int>(kind)), make(kind), false});
  }
  for (const TypeRef& type : {colour, matrix, point, words, make(StringType{}),
                              make(SequenceType{words, 4}), make(SequenceType{matrix, 0}),
                              make(ArrayType{point, {4}}), make(ArrayType{words, {2, 2, 2}})}) {
    all.members.push_back({"made_" + std::to_string(all.members.size()), type, false});
  }
  return TypeModel(make(std::move(all)));
}

TEST(ParseIdl, IsTheReverseOfIdlText) {
  const TypeModel model = everything();
  const TypeModel parsed = parse_idl(idl_text(model), "a::b::Everything");
  EXPECT_TRUE(same_type(*parsed.type(), *model.type())) << idl_text(parsed);
}

/// What stands in the text of others, but never in idl_text()'s.
constexpr const char* kForeign = R"(
#include "somewhere/else.idl"
#pragma keylist Reading id
/* Two lines;
   struct Nothing { long x; }; */
module outer {
  const long SIZE = 0x10; // sixteen
  const string GREETING = "}; // no comment";
  const double RATIO = 1.5e-3;
  module inner {
    const unsigned short HALF = (outer::SIZE / 2 + 1) * -1 + 17 % 10 - -010;
    @bit_bound(32) enum Kind { @default_literal FIRST, @value(5) SECOND, THIRD };
    struct Later;
    @extensibility(APPENDABLE) @nested
    struct Base { @key @id(3) unsigned long long id; };
  };
  typedef sequence<octet, SIZE> Blob, Blobs[inner::HALF];
  module inner {
    @verbatim(language="c++", text="struct { ( ")
    @final struct Reading : Base {
      @unit("m") @range(min=-1, max=+1) double a, b[2], c[SIZE][2];
      @key(FALSE) string<SIZE> _module;
      ::outer::Blobs blobs;
      Kind kind;
      sequence<sequence<uint8>> raw;
      @optional(FALSE) int64 big;
    };
  };
};
)";

TEST(ParseIdl, TakesWhatOthersWrite) {
  const TypeModel model = parse_idl(kForeign, "outer::inner::Reading");
  EXPECT_THAT(idl_text(model), HasSubstr("typedef sequence<octet, 16> Blobs[6];\n"));
  EXPECT_THAT(idl_text(model),
              HasSubstr("enum Kind {\n  FIRST,\n  @value(5) SECOND,\n  THIRD\n};\n"));
  EXPECT_THAT(idl_text(model), HasSubstr("@final struct Reading {\n"
                                         "  @key unsigned long long id;\n"
                                         "  double a;\n"
                                         "  double b[2];\n"
                                         "  double c[16][2];\n"
                                         "  string<16> module;\n"
                                         "  outer::Blobs blobs;\n"
                                         "  outer::inner::Kind kind;\n"
                                         "  sequence<sequence<octet>> raw;\n"
                                         "  long long big;\n"
                                         "};\n"));
}

TEST(ParseIdl, FindsTheInnermostName) {
  const char* text =
      "struct T { long a; }; module m { struct T { float b; }; module n { struct U { T inner; ::T "
      "outer; m::T same; }; }; };";
  EXPECT_THAT(idl_text(parse_idl(text, "m::n::U")),
              HasSubstr("  m::T inner;\n  T outer;\n  m::T same;\n"));
}

struct BadIdl {
  const char* text;
  const char* error;
};
void PrintTo(const BadIdl& bad, std::ostream* out) { *out << bad.text; }

struct BadIdlText : testing::TestWithParam<BadIdl> {};

TEST_P(BadIdlText, IsRefusedWithItsLine) {
  EXPECT_THAT([] { parse_idl(GetParam().text, "T"); },
              ThrowsMessage<Error>(HasSubstr(GetParam().error)));
}

const BadIdl kBad[] = {
    {"", "no type T in the IDL text"},
    {"enum T { A };", "a topic type must be a struct"},
    {"struct T {\n  long a\n};", "line 3: expected ';', found '}'"},
    {"struct T {\n\n  Unheard a;\n};", "line 3: type Unheard is not declared"},
    {"struct T { long a;", "line 1: expected a name, found the end of the text"},
    {"struct T { };", "line 1: struct T without members"},
    {"struct T { long a; long a; };", "T.a is declared twice"},
    {"struct T { long a; }; struct T { long b; };", "T is declared twice"},
    {"struct T { T again; };", "type T is not declared"},
    {"struct T { long a[0]; };", "0 is no size"},
    {"struct T { long a[-3]; };", "-3 is no size"},
    {"struct T { long a[5000000000]; };", "5000000000 is no size"},
    {"struct T { long a[99999999999999999999]; };", "is no integer"},
    {"struct T { long a[1 / 0]; };", "a division by zero"},
    {"struct T { long a[9223372036854775807 * 2]; };", "a number beyond 64 bits"},
    {"struct T { long a[N]; };", "N is no integer constant"},
    {"struct T { string<1.5> a; };", "1.5 is no integer"},
    {"struct T { sequence<long a; };", "expected '>', found 'a'"},
    {"struct T : Nobody { long a; };", "Nobody is no struct"},
    {"struct T { unsigned float a; };", "no type unsigned float"},
    {"struct T { @optional long a; };", "optional member of T not supported"},
    {"struct T { wstring a; };", "wstring in this place not supported"},
    {"struct T { map<long, long> a; };", "map in this place not supported"},
    {"struct T { long double a; };", "long double not supported"},
    {"@mutable struct T { long a; };", "mutable struct T not supported"},
    {"@bit_bound(8) enum E { A }; struct T { E e; };", "enum E of 8 bits not supported"},
    {"enum E { @value(3000000000) A };", "a value of E beyond 32 bits"},
    {"\nunion T switch (long) { case 0: long a; };", "line 2: union not supported"},
    {"bitmask T { A };", "bitmask not supported"},
    {"nonsense;", "line 1: expected a declaration, found 'nonsense'"},
    {"module m {", "'{' without '}'"},
    {"@verbatim(", "'(' without ')'"},
    {"/* for ever", "line 1: a comment without end"},
    {"const string A = \"for ever;\n", "line 1: a literal without end"},
    {"struct T { long \xC3\xA4; };", "a character that IDL does not have"},
};
INSTANTIATE_TEST_SUITE_P(, BadIdlText, testing::ValuesIn(kBad));

std::string repeated(const std::string& text, int times) {
  std::string out;
  for (int i = 0; i < times; ++i) out += text;
  return out;
}

TEST(ParseIdl, NoNestingEndsTheProcess) {
  constexpr int kMany = 100'000;
  const auto parse = [](const std::string& text) { return [=] { parse_idl(text, "T"); }; };
  const auto too_deep = ThrowsMessage<Error>(HasSubstr("nested too deep"));
  EXPECT_THAT(parse("struct T { " + repeated("sequence<", kMany)), too_deep);
  EXPECT_THAT(parse("struct T { long a[" + repeated("(", kMany)), too_deep);
  EXPECT_THAT(parse("struct T { long a[" + repeated("-", kMany)), too_deep);
  EXPECT_THAT(parse(repeated("module m { ", kMany)), too_deep);
  std::string chain = "typedef long T0; ";
  std::string doubling = "struct T0 { long a; long b; }; ";
  for (int i = 1; i < 1000; ++i) {
    const std::string before = "T" + std::to_string(i - 1);
    const std::string name = "T" + std::to_string(i);
    chain += "typedef " + before + " " + name + "; ";
    doubling += "struct " + name + " { " + before + " a; " + before + " b; }; ";
  }
  EXPECT_THAT(parse(chain), too_deep);
  EXPECT_THAT(parse(doubling), ThrowsMessage<Error>(HasSubstr("too many members")));
}

/// Parses, and uses what comes out of it.
void try_out(const std::string& text, const std::string& name) {
  try {
    const TypeModel model = parse_idl(text, name);
    const TypeModel again = parse_idl(idl_text(model), name);
    EXPECT_TRUE(same_type(*model.type(), *again.type())) << text;
  } catch (const Error&) {
    return;  // refused, which is as good
  }
}

TEST(ParseIdl, MutatedTextNeverCrashes) {
  std::mt19937 random(7);
  const auto below = [&](std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  };
  const std::pair<std::string, std::string> sources[] = {
      {kForeign, "outer::inner::Reading"},
      {idl_text(known("scarab::WorldState")), "scarab::WorldState"}};
  const std::string alphabet = "{}()<>[];,:=@+-*/%\"'#\\ \n0159xaL_";
  for (int round = 0; round < 4000; ++round) {
    const auto& [source, name] = sources[below(2)];
    std::string text = source;
    for (std::size_t i = below(6) + 1; i > 0; --i) {
      const std::size_t at = below(text.size());
      const std::size_t from = below(text.size());
      const std::size_t size = below(30);
      switch (below(4)) {
        case 0:
          text[at] = alphabet[below(alphabet.size())];
          break;
        case 1:
          text.erase(at, size);
          break;
        case 2:
          text.insert(at, text.substr(from, size));
          break;
        default:
          text[at] = static_cast<char>(below(256));
      }
      if (text.empty()) text = ";";
    }
    try_out(text, name);
  }
}

}  // namespace
}  // namespace scarab::sample
