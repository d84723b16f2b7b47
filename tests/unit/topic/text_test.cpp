#include <gmock/gmock.h>

#include "common/config/json_object.hpp"
#include "tools/topic/failure.hpp"
#include "tools/topic/quantity.hpp"
#include "tools/topic/text_table.hpp"

namespace scarab::topic {
namespace {

TEST(TextTable, AlignsItsColumns) {
  TextTable table({{"NAME"}, {"COUNT", true}, {"WHERE"}});
  table.add({"é", "7", "here"});
  table.add_note("  ! a note that is wider than the table");
  table.add({"longer", "12345678", ""});
  EXPECT_EQ(table.width(), 6U + 2U + 8U + 2U + 5U);
  EXPECT_EQ(table.text(),
            "NAME       COUNT  WHERE\n"
            "é              7  here\n"
            "  ! a note that is wider than the table\n"
            "longer  12345678\n");
}

TEST(Quantity, HasUnitsThatFit) {
  EXPECT_EQ(bytes_text(0), "0 B");
  EXPECT_EQ(bytes_text(999), "999 B");
  EXPECT_EQ(bytes_text(999.7), "1.00 kB");
  EXPECT_EQ(bytes_text(20400), "20.4 kB");
  EXPECT_EQ(bytes_text(1.234e8), "123 MB");
  EXPECT_EQ(seconds_text(0.5), "0.5 s");
  EXPECT_EQ(seconds_text(20), "20 s");
  EXPECT_EQ(rounded(0.01234), "0.0123");
  EXPECT_EQ(rounded(98.76), "98.8");
  EXPECT_EQ(rounded(12345.6), "12346");
  EXPECT_EQ(counted(1, "sample"), "1 sample");
  EXPECT_EQ(counted(0, "sample"), "0 samples");
}

TEST(JsonObject, QuotesTextAndKnowsNoNan) {
  EXPECT_EQ(config::JsonObject().text("a", "b\"c").number("d", 0.5).number("e", 0.0 / 0.0).str(),
            "{\"a\": \"b\\\"c\", \"d\": 0.5, \"e\": null}");
  EXPECT_EQ(config::json_list({"1", "{}"}), "[1, {}]");
  EXPECT_EQ(config::json_list({}), "[]");
}

TEST(Failure, SuggestsOnlyWhatMayBeMeant) {
  EXPECT_EQ(did_you_mean("scarab/robot_stat", {"scarab/trial", "scarab/robot_state"}),
            "; did you mean scarab/robot_state?");
  EXPECT_EQ(did_you_mean("x", {"scarab/trial"}), "");
}

}  // namespace
}  // namespace scarab::topic
