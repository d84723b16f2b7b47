#include "services/robot_bridge/drivers/dynamixel/protocol/control_table.hpp"

#include <gtest/gtest.h>

#include <string_view>

#include "tests/unit/robot_bridge/dynamixel/frames.hpp"

namespace scarab::bridge::dynamixel {
namespace {

TEST(ControlTable, CountsOfEveryType) {
  struct Case {
    Type type;
    std::int64_t count;
    std::string_view bytes;
  };
  const Case cases[] = {{Type::kU8, 255, "FF"},
                        {Type::kI8, -1, "FF"},
                        {Type::kI8, -128, "80"},
                        {Type::kU16, 0xFFFE, "FE FF"},
                        {Type::kI16, -2, "FE FF"},
                        {Type::kU32, 4294967295, "FF FF FF FF"},
                        {Type::kI32, -166, "5A FF FF FF"},
                        {Type::kI32, 2079, "1F 08 00 00"}};
  for (const Case& c : cases) {
    const Item item{0, c.type, 1};
    EXPECT_EQ(count_in(item, hex(c.bytes)), c.count) << c.bytes;
    EXPECT_EQ(bytes_of(item, c.count), hex(c.bytes)) << c.bytes;
  }
}

TEST(ControlTable, ValuesHaveUnits) {
  const ServoModel xm430;
  EXPECT_DOUBLE_EQ(value_in(xm430.present_current, hex("64 00")), 0.269);
  EXPECT_DOUBLE_EQ(value_in(xm430.present_current, hex("9C FF")), -0.269);
  EXPECT_NEAR(value_in(xm430.present_velocity, hex("64 00 00 00")), 22.9 / 60 * 6.283185307, 1e-8);
  EXPECT_NEAR(value_in(xm430.present_position, hex("00 04 00 00")), 3.14159265358979 / 2, 1e-12);
  EXPECT_DOUBLE_EQ(value_in(xm430.present_voltage, hex("77 00")), 11.9);
  EXPECT_EQ(bytes_of_value(xm430.present_current, -0.269), hex("9C FF"));
}

TEST(ControlTable, AValueBeyondItsTypeIsItsEnd) {
  EXPECT_EQ(bytes_of_value({0, Type::kU8, 1}, 300), hex("FF"));
  EXPECT_EQ(bytes_of_value({0, Type::kU8, 1}, -3), hex("00"));
  EXPECT_EQ(bytes_of_value({0, Type::kI16, 0.001}, -1e6), hex("00 80"));
}

TEST(ControlTable, Floats) {
  const Item item{0, Type::kF32, 2};
  EXPECT_EQ(bytes_of_value(item, 2), hex("00 00 80 3F"));  // IEEE 754: 1.0
  EXPECT_DOUBLE_EQ(value_in(item, hex("00 00 20 C1")), -20);
}

TEST(ControlTable, AHullHoldsBoth) {
  EXPECT_EQ(hull({126, 2}, {132, 4}), (Region{126, 10}));
  EXPECT_EQ(hull({132, 4}, {126, 2}), (Region{126, 10}));
  EXPECT_EQ(hull({10, 20}, {12, 2}), (Region{10, 20}));
}

// Addresses and sizes as printed in the e-Manual's tables of the XM430-W350.
TEST(ControlTable, Xm430W350) {
  const ServoModel xm430;
  EXPECT_EQ(xm430.model_number, 1020);
  const std::vector<std::pair<std::string_view, Region>> manual = {
      {"return_delay", {9, 1}},         {"drive_mode", {10, 1}},
      {"operating_mode", {11, 1}},      {"temperature_limit", {31, 1}},
      {"current_limit", {38, 2}},       {"max_position_limit", {48, 4}},
      {"min_position_limit", {52, 4}},  {"torque_enable", {64, 1}},
      {"status_return_level", {68, 1}}, {"hardware_error_status", {70, 1}},
      {"bus_watchdog", {98, 1}},        {"goal_position", {116, 4}},
      {"present_current", {126, 2}},    {"present_velocity", {128, 4}},
      {"present_position", {132, 4}},   {"present_voltage", {144, 2}},
      {"present_temperature", {146, 1}}};
  std::vector<std::pair<std::string_view, Region>> ours;
  for_each_item(xm430, [&](std::string_view name, const Item& item) {
    ours.emplace_back(name, item.region());
  });
  EXPECT_EQ(ours, manual);
}

TEST(ControlTable, HardwareErrorsInWords) {
  EXPECT_EQ(hardware_error_text(0), "");
  EXPECT_EQ(hardware_error_text(kOverloadError), "overload");
  EXPECT_EQ(hardware_error_text(kOverheatingError | kInputVoltageError),
            "input voltage, overheating");
  EXPECT_EQ(hardware_error_text(0x40 | kEncoderError), "motor encoder, unknown bits 64");
}

}  // namespace
}  // namespace scarab::bridge::dynamixel
