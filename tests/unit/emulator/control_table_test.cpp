#include "tools/emulator/boards/dynamixel/control_table.hpp"

#include <gtest/gtest.h>

namespace scarab::emulator {
namespace {

using dxl::Bytes;
using dxl::StatusError;
using dxl::Type;

constexpr dxl::Item kSetting{10, Type::kU8, 1};
constexpr dxl::Item kGoal{20, Type::kI32, 0.5};
constexpr dxl::Item kSpeed{24, Type::kU16, 1};
constexpr dxl::Item kPresent{40, Type::kI16, 0.5};

ControlTable table() {
  ControlTable out;
  out.add({kSetting, Access::kEeprom, 3, 0, 9});
  out.add({kGoal, Access::kRam, -2, -100, 100});
  out.add({kSpeed, Access::kRam, 7, 0, 50});
  out.add({kPresent, Access::kRead});
  return out;
}

TEST(ControlTable, HoldsWhatItWasGiven) {
  ControlTable t = table();
  EXPECT_EQ(t.get(kGoal), -2);
  t.set(kPresent, -5);
  EXPECT_EQ(t.get(kPresent), -5);
  t.set_value(kPresent, 3.1);
  EXPECT_EQ(t.get(kPresent), 6);
  EXPECT_EQ(t.read({20, 6}), (Bytes{0xFE, 0xFF, 0xFF, 0xFF, 7, 0}));
}

TEST(ControlTable, GapsReadZeroAndNowhereIsAnError) {
  EXPECT_EQ(table().read({9, 4}), (Bytes{0, 3, 0, 0}));
  EXPECT_FALSE(table().read({100, 4}));
}

TEST(ControlTable, WritesAreForWhoMay) {
  const ControlTable t = table();
  EXPECT_EQ(t.check(20, Bytes{1, 0, 0, 0}, true), StatusError::kNone);
  EXPECT_EQ(t.check(20, Bytes{1, 0, 0, 0, 50, 0}, true), StatusError::kNone) << "two fields";
  EXPECT_EQ(t.check(40, Bytes{1, 0}, false), StatusError::kAccess) << "read only";
  EXPECT_EQ(t.check(10, Bytes{1}, true), StatusError::kAccess) << "EEPROM under torque";
  EXPECT_EQ(t.check(10, Bytes{1}, false), StatusError::kNone);
  EXPECT_EQ(t.check(60, Bytes{1}, false), StatusError::kAccess) << "nothing there";
  EXPECT_EQ(t.check(24, Bytes{1, 0, 0}, false), StatusError::kAccess) << "nothing behind it";
}

TEST(ControlTable, WritesAreOfWholeFieldsInTheirRange) {
  const ControlTable t = table();
  EXPECT_EQ(t.check(20, Bytes{1, 0}, true), StatusError::kDataLength);
  EXPECT_EQ(t.check(22, Bytes{0, 0, 1, 0}, true), StatusError::kDataLength);
  EXPECT_EQ(t.check(24, Bytes{51, 0}, true), StatusError::kDataRange);
  EXPECT_EQ(t.check(20, Bytes{0x9B, 0xFF, 0xFF, 0xFF}, true), StatusError::kDataRange) << "-101";
}

TEST(ControlTable, AResetLeavesTheEeprom) {
  ControlTable t = table();
  t.set(kSetting, 9);
  t.set(kGoal, 50);
  t.reset_ram();
  EXPECT_EQ(t.get(kSetting), 9);
  EXPECT_EQ(t.get(kGoal), -2);
}

TEST(ControlTable, AFieldTakesThePlaceOfThoseItCovers) {
  ControlTable t = table();
  t.add({{22, Type::kU32, 1}, Access::kRam, 5, 0, 9});
  EXPECT_EQ(t.check(20, Bytes{1, 0, 0, 0}, false), StatusError::kDataLength);
  EXPECT_EQ(t.get({22, Type::kU32, 1}), 5);
}

}  // namespace
}  // namespace scarab::emulator
