#include "common/sample/type_model.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <regex>

#include "common/bus/c_layout.hpp"
#include "common/bus/known_types.hpp"
#include "common/bus/topic_type.hpp"
#include "common/bus/topics.hpp"
#include "common/sample/idl_text.hpp"

namespace scarab::sample {
namespace {

using testing::HasSubstr;
using testing::Not;

TypeRef make(decltype(Type::kind) kind) {
  return std::make_shared<const Type>(Type{std::move(kind)});
}

struct KnownType : testing::TestWithParam<std::string> {
  const dds_topic_descriptor_t& descriptor = *bus::find_known_type(GetParam());
  TypeModel model = bus::model_of(descriptor);
};

TEST_P(KnownType, HasTheNameAndTheLayoutOfTheCStruct) {
  EXPECT_EQ(model.name(), GetParam());
  const bus::CLayout layout = bus::c_layout(*model.type());
  EXPECT_EQ(layout.size, descriptor.m_size);
  EXPECT_EQ(layout.alignment, descriptor.m_align);
}

TEST_P(KnownType, HasAsManyKeysAsItsDescriptor) {
  const auto& members = model.root().members;
  const auto keys =
      std::count_if(members.begin(), members.end(), [](const auto& m) { return m.key; });
  EXPECT_EQ(keys, descriptor.m_nkeys);
}

TEST_P(KnownType, IsWrittenAsIdlThatEveryReaderTakes) {
  const std::string text = idl_text(model);
  for (const char* refused : {"0x", "#", "@optional", "@appendable", "//"}) {
    EXPECT_THAT(text, Not(HasSubstr(refused)));
  }
  EXPECT_FALSE(std::regex_search(text, std::regex(R"((^|[^\w])::\w)"))) << text;
  // One text without unknown names: each scoped name has been declared further up.
  const std::regex name(R"(scarab::(\w+))");
  for (std::sregex_iterator it(text.begin(), text.end(), name), end; it != end; ++it) {
    const std::string before = text.substr(0, static_cast<std::size_t>(it->position()));
    const std::regex declaration("(struct|enum|typedef .*) " + (*it)[1].str() + "[ ;\\[]");
    EXPECT_TRUE(std::regex_search(before, declaration)) << it->str();
  }
}

INSTANTIATE_TEST_SUITE_P(, KnownType, testing::ValuesIn(bus::known_type_names()),
                         [](const auto& type) { return type.param.substr(8); });

TEST(TypeModel, KnowsMembersOfEveryKind) {
  const TypeModel model = bus::model_of(bus::descriptor<scarab_WorldState>());
  const auto& members = model.root().members;
  const auto member = [&](const std::string& name) -> const Type& {
    const auto found = std::find_if(members.begin(), members.end(),
                                    [&](const Member& m) { return m.name == name; });
    return *found->type;
  };
  const auto& contacts = std::get<SequenceType>(member("contacts").kind);
  EXPECT_EQ(contacts.bound, 96U);
  EXPECT_EQ(std::get<StructType>(contacts.element->kind).name, "scarab::Contact");
  EXPECT_EQ(std::get<StringType>(member("verdict_reason").kind).bound, 127U);
  EXPECT_EQ(std::get<Primitive>(member("obstacle_present").kind), Primitive::kBoolean);
  const auto& verdict = std::get<EnumType>(member("verdict").kind);
  EXPECT_EQ(*verdict.name_of(scarab_VERDICT_FAILURE), "VERDICT_FAILURE");
  EXPECT_EQ(verdict.name_of(3), nullptr);
}

TEST(IdlText, WritesWhatOtherTypesMayHave) {
  const TypeRef colour = make(EnumType{"a::Colour", {{"RED", 0}, {"GREEN", 7}, {"BLUE", 8}}});
  const TypeRef matrix =
      make(AliasType{"a::b::Matrix", make(ArrayType{make(Primitive::kDouble), {2, 3}})});
  const TypeRef words = make(SequenceType{make(StringType{}), 0});
  const TypeModel model(make(StructType{"a::b::Thing",
                                        {{"id", make(Primitive::kInt16), true},
                                         {"paint", colour, false},
                                         {"weights", matrix, false},
                                         {"words", words, false},
                                         {"tag", make(StringType{5}), false},
                                         {"limits", make(ArrayType{colour, {2}}), false}}}));
  EXPECT_EQ(idl_text(model),
            "module a {\n"
            "enum Colour {\n  RED,\n  @value(7) GREEN,\n  BLUE\n};\n"
            "};\n"
            "module a {\nmodule b {\n"
            "typedef double Matrix[2][3];\n"
            "@final struct Thing {\n"
            "  @key short id;\n"
            "  a::Colour paint;\n"
            "  a::b::Matrix weights;\n"
            "  sequence<string> words;\n"
            "  string<5> tag;\n"
            "  a::Colour limits[2];\n"
            "};\n"
            "};\n};\n");
}

}  // namespace
}  // namespace scarab::sample
