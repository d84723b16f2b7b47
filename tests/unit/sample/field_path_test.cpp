#include "common/sample/field_path.hpp"

#include <gmock/gmock.h>

#include <vector>

#include "common/bus/cdr.hpp"
#include "common/bus/sample_fields.hpp"
#include "common/bus/topic_type.hpp"
#include "common/bus/topics.hpp"
#include "common/sample/field_values.hpp"
#include "common/sample/sample_columns.hpp"
#include "common/sample/sample_text.hpp"

namespace scarab::sample {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const TypeModel kModel = bus::model_of(bus::descriptor<scarab_WorldState>());

/// A sample with two contacts.
Bytes world() {
  std::vector<scarab_Contact> contacts(2);
  contacts[0].depth_m = 0.25;
  contacts[1].force_n[2] = -3.5;
  contacts[1].solid_b = scarab_SOLID_FOOT;
  scarab_WorldState state{};
  state.header.tick = 41;
  state.trunk.position_m[1] = 0.125;
  bus::borrow(state.contacts, contacts);
  bus::assign(state.verdict_reason, "over the wall");
  return bus::encode(state);
}

std::string error_of(const std::string& path) {
  try {
    FieldPath(kModel, path);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(FieldPath, FindsWhatColumnsAreCalled) {
  const Bytes cdr = world();
  const SampleNode sample = sample_tree(kModel, cdr);
  const ColumnOptions options{3};
  const auto names = column_names(kModel, options);
  const auto values = column_values(kModel, cdr, options);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const FieldPath path(kModel, names[i]);
    EXPECT_TRUE(path.is_scalar()) << names[i];
    EXPECT_EQ(path.text(), names[i]);
    const SampleNode* node = path.find(sample);
    if (path.is_length()) {
      ASSERT_NE(node, nullptr);
      EXPECT_EQ(std::to_string(std::get<SampleNode::List>(node->value).size()), values[i]);
    } else if (names[i].find("contacts[2]") == 0) {
      EXPECT_EQ(node, nullptr) << names[i];
    } else {
      ASSERT_NE(node, nullptr) << names[i];
      EXPECT_EQ(scalar_text(std::get<Scalar>(node->value)), values[i]) << names[i];
    }
  }
}

TEST(FieldPath, ReadsTheSameValuesWithoutATree) {
  const Bytes cdr = world();
  const ColumnOptions options{3};
  std::vector<FieldPath> paths;
  for (const std::string& name : column_names(kModel, options)) paths.emplace_back(kModel, name);
  std::vector<std::string> read;
  for (const auto& value : FieldValues(kModel, paths).read(cdr)) {
    read.push_back(value ? scalar_text(*value) : "");
  }
  EXPECT_EQ(read, column_values(kModel, cdr, options));
}

TEST(FieldPath, NamesTheBeginningOfOthers) {
  const Bytes cdr = world();
  const SampleNode sample = sample_tree(kModel, cdr);
  const FieldPath contact(kModel, "contacts[1]");
  EXPECT_FALSE(contact.is_scalar());
  EXPECT_EQ(std::get<StructType>(resolve(*contact.type()).kind).name, "scarab::Contact");
  EXPECT_EQ(std::get<SampleNode::Struct>(contact.find(sample)->value)[0].first, "solid_a");
  EXPECT_THROW(FieldValues(kModel, {contact}), Error);
}

TEST(FieldPath, StepsThroughEachDimensionOfAnArray) {
  const auto make = [](decltype(Type::kind) kind) {
    return std::make_shared<const Type>(Type{std::move(kind)});
  };
  const TypeModel matrix(
      make(StructType{"m::Matrix", {{"rows", make(ArrayType{make(Primitive::kInt32), {2, 3}})}}}));
  EXPECT_TRUE(FieldPath(matrix, "rows[1][2]").is_scalar());
  const FieldPath row(matrix, "rows[1]");
  EXPECT_THAT(std::get<ArrayType>(row.type()->kind).dimensions, ElementsAre(3));
  EXPECT_THROW(FieldPath(matrix, "rows[2][0]"), Error);
  EXPECT_THROW(FieldPath(matrix, "rows[1][3]"), Error);
  EXPECT_THROW(FieldPath(matrix, "rows[1][2][0]"), Error);
}

TEST(FieldPath, SaysWhichNamesThereAre) {
  try {
    FieldPath(kModel, "header.tik");
    FAIL() << "no error";
  } catch (const NoSuchMember& error) {
    EXPECT_EQ(error.name(), "tik");
    EXPECT_THAT(error.known(), ElementsAre("trial", "tick", "sim_time_ns", "stamp_ns"));
    EXPECT_STREQ(error.what(),
                 "no member tik in scarab::Header; it has trial, tick, sim_time_ns, stamp_ns");
    EXPECT_STREQ(NoSuchMember("column 3", error).what(),
                 (std::string("column 3: ") + error.what()).c_str());
  }
}

TEST(FieldPath, SaysWhatIsWrongWithAPath) {
  EXPECT_EQ(error_of("trunk.position_m[3]"),
            "trunk.position_m[3]: trunk.position_m has 3 elements, [0] to [2]");
  EXPECT_EQ(error_of("contacts[96].depth_m"),
            "contacts[96].depth_m: contacts has at most 96 elements, [0] to [95]");
  EXPECT_EQ(error_of("contacts.depth_m"),
            "contacts.depth_m: contacts is a list; its elements are contacts[0], ...");
  EXPECT_EQ(error_of("header.tick.x"),
            "header.tick.x: header.tick is of type unsigned long, without members");
  EXPECT_EQ(error_of("header.tick[0]"), "header.tick[0]: header.tick is no list");
  EXPECT_EQ(error_of("contacts[x]"),
            "contacts[x]: 'x' is no index; the first element is contacts[0]");
  EXPECT_EQ(error_of("contacts[-1]"),
            "contacts[-1]: '-1' is no index; the first element is contacts[0]");
  EXPECT_EQ(error_of("contacts[0"), "contacts[0: [ without ]");
  EXPECT_EQ(error_of("contacts[0]depth_m"),
            "contacts[0]depth_m: . or [ expected after contacts[0]");
  EXPECT_EQ(error_of("contacts.length.x"), "contacts.length.x: nothing lies below contacts.length");
  EXPECT_EQ(error_of("header."), "header.: a name is missing");
  EXPECT_EQ(error_of(""), "a field without name");
  EXPECT_THAT(error_of(".header"), HasSubstr("a name is missing"));
  EXPECT_THAT(error_of("[0]"), HasSubstr("a name is missing"));
}

TEST(FieldPath, SelectsColumns) {
  EXPECT_TRUE(has_column("header", "header.tick"));
  EXPECT_TRUE(has_column("contacts", "contacts[0].depth_m"));
  EXPECT_TRUE(has_column("contacts", "contacts.length"));
  EXPECT_TRUE(has_column("mode", "mode"));
  EXPECT_FALSE(has_column("head", "header.tick"));
  EXPECT_FALSE(has_column("position_rad[1]", "position_rad[10]"));
}

}  // namespace
}  // namespace scarab::sample
