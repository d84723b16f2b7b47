/// Samples as tables.
#include "tools/log/table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

#include "common/bus/topic_type.hpp"
#include "common/sample/sample_columns.hpp"
#include "tests/unit/log/behaviour_log.hpp"
#include "tests/unit/mcap/temporary_folder.hpp"
#include "tools/log/row.hpp"

namespace scarab::log::test {
namespace {

using mcap::test::TemporaryFolder;
using testing::HasSubstr;

class Table : public testing::Test {
 protected:
  Table() {
    LogWriter log(folder_ / "x.mcap");
    log.write(behaviour(1, 0, 5));
    log.write(behaviour(2, 1, 6));
    const auto meadow = log.add_channel("meadow", "meadow::Patch", "omgidl", kMeadowIdl);
    log.write(meadow, 7, patch(2.5, {7, 8, 9}));
    log.write(meadow, 8, patch(0.5, {}));
    log.close();
  }
  std::string table(const TableOptions& options, const SelectionOptions& wanted = {},
                    bool json = false) const {
    const Log log(folder_ / "x.mcap");
    SelectionOptions selected = wanted;
    selected.topics = {options.topic};
    const Selection selection(log, selected);
    std::ostringstream out;
    json ? write_json(log, selection, options, out) : write_csv(log, selection, options, out);
    return out.str();
  }
  std::string refusal(const TableOptions& options, const SelectionOptions& wanted = {}) const {
    try {
      return table(options, wanted);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  }
  static SelectionOptions of_trial(std::uint32_t trial) {
    SelectionOptions options;
    options.trial = trial;
    return options;
  }

  TemporaryFolder folder_;
};

TEST_F(Table, HasTheFieldsAskedForWithEnumsByNameAndTextQuoted) {
  EXPECT_EQ(table({"scarab/behaviour", {"header.tick", "mode", "hind_pose_rad", "reason"}}),
            "header.tick,mode,hind_pose_rad[0],hind_pose_rad[1],hind_pose_rad[2],reason\n"
            "0,MODE_BACKWARD,0,0,0,\"walks, \"\"slowly\"\"\"\n"
            "1,MODE_BACKWARD,0,0,0,\"walks, \"\"slowly\"\"\"\n");
  EXPECT_EQ(table({"scarab/behaviour", {"header.trial", "header.tick"}}, of_trial(2)),
            "header.trial,header.tick\n2,1\n");
  EXPECT_EQ(table({"scarab/behaviour", {"header.tick"}, 0, true}, of_trial(1)),
            "log_time_ns,publish_time_ns,header.tick\n1000000000,0,0\n");
}

TEST_F(Table, HasTheRowsThatAFilterLeaves) {
  SelectionOptions options;
  options.filter = "header.tick > 0 AND mode = 'MODE_BACKWARD'";
  EXPECT_EQ(table({"scarab/behaviour", {"header.tick"}}, options), "header.tick\n1\n");
}

TEST_F(Table, OfAForeignTypeIsReadByItsSchema) {
  EXPECT_EQ(table({"meadow", {}, 2}),
            "area_m2,flowers.length,flowers[0],flowers[1],kind\n"
            "2.5,3,7,8,CLOVER\n"
            "0.5,0,,,CLOVER\n");
}

TEST_F(Table, IsJsonToo) {
  EXPECT_EQ(table({"meadow", {}}, {}, true),
            "[\n"
            "{\"area_m2\": 2.5, \"flowers\": [7, 8, 9], \"kind\": \"CLOVER\"},\n"
            "{\"area_m2\": 0.5, \"flowers\": [], \"kind\": \"CLOVER\"}\n"
            "]\n");
  EXPECT_EQ(table({"meadow", {"flowers[2]", "flowers.length"}, 0, true}, {}, true),
            "[\n"
            "{\"log_time_ns\": \"3000000000\", \"publish_time_ns\": \"7\", \"flowers[2]\": 9, "
            "\"flowers.length\": 3},\n"
            "{\"log_time_ns\": \"4000000000\", \"publish_time_ns\": \"8\", \"flowers[2]\": null, "
            "\"flowers.length\": 0}\n"
            "]\n");
  SelectionOptions nothing;
  nothing.filter = "area_m2 < 0";
  EXPECT_EQ(table({"meadow", {}}, nothing, true), "[]\n");
}

TEST_F(Table, SaysWhichTopicsAndFieldsThereAre) {
  EXPECT_THAT(refusal({"scarab/nothing", {}}), HasSubstr("there are meadow scarab/behaviour"));
  EXPECT_THAT(refusal({"scarab/behaviour", {"mod"}}), HasSubstr("no field mod; there are"));
  EXPECT_THAT(refusal({"meadow", {}}, of_trial(1)), HasSubstr("no header, so no trial"));
  SelectionOptions filter;
  filter.filter = "height > 3";
  EXPECT_THAT(refusal({"meadow", {}}, filter), HasSubstr("no member height in meadow::Patch"));
}

/// The same cells as the bus makes of a tree, for every column of a type with nested lists.
TEST(Row, HasTheValuesOfTheColumns) {
  scarab_WorldState world{};
  world.object_travel_m = 0.25;
  std::vector<scarab_Contact> contacts(3);
  contacts[1].point_m[2] = -1.5;
  contacts[2].solid_b = scarab_SOLID_FOOT;
  bus::borrow(world.contacts, contacts);
  bus::assign(world.verdict_reason, "on its way");
  const auto type = bus::model_of(bus::descriptor<scarab_WorldState>());
  const sample::Bytes cdr = bus::encode(world);
  for (const std::size_t elements : {0U, 2U, 3U, 5U, 200U}) {
    const sample::ColumnOptions options{elements};
    const auto values = sample::column_values(type, cdr, options);
    std::vector<std::size_t> all(values.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    Row row(type, options, all);
    EXPECT_EQ(row.read(cdr), values) << elements;
    EXPECT_EQ(row.read(cdr), values) << "the second time";
  }
}

}  // namespace
}  // namespace scarab::log::test
