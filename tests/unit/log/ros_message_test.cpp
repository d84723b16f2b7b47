/// Types of the logs of rosbag2.
#include "tools/log/ros_message.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "common/bus/error.hpp"
#include "common/sample/idl_text.hpp"
#include "tests/unit/log/behaviour_log.hpp"
#include "tests/unit/mcap/temporary_folder.hpp"
#include "tools/log/cat.hpp"

namespace scarab::log::test {
namespace {

using testing::HasSubstr;

// As rosbag2 writes the definition of a message and of what it is made of.
constexpr const char* kJointState =
    "# a comment\n"
    "std_msgs/Header header\n"
    "\n"
    "uint8 KIND_A=1\n"
    "string NAME = \"x\"\n"
    "string[] name          # one a joint\n"
    "float64[] position\n"
    "int32[3] fixed\n"
    "uint8[<=5] few\n"
    "int8 start -1\n"
    "================================================================================\n"
    "MSG: std_msgs/Header\n"
    "builtin_interfaces/Time stamp\n"
    "string<=8 frame_id\n"
    "================================================================================\n"
    "MSG: builtin_interfaces/Time\n"
    "int32 sec\n"
    "uint32 nanosec\n";

std::string idl_of(const std::string& text, const std::string& name) {
  return sample::idl_text(parse_ros_message(text, name));
}
std::string refusal(const std::string& text) {
  try {
    parse_ros_message(text, "a/msg/B");
  } catch (const bus::Error& error) {
    return error.what();
  }
  return "";
}

TEST(RosMessage, HasTheFieldsOfItsDefinition) {
  const auto type = parse_ros_message(kJointState, "sensor_msgs/msg/JointState");
  EXPECT_EQ(type.name(), "sensor_msgs/JointState");
  std::vector<std::string> fields;
  for (const auto& member : type.root().members) {
    const auto* array = std::get_if<sample::ArrayType>(&member.type->kind);
    fields.push_back(sample::idl_type_name(array != nullptr ? *array->element : *member.type) +
                     " " + member.name);
  }
  EXPECT_THAT(fields, testing::ElementsAre(HasSubstr("std_msgs/Header"), "sequence<string> name",
                                           "sequence<double> position", "long fixed",
                                           "sequence<octet, 5> few", HasSubstr(" start")));
}

TEST(RosMessage, IsReadInALog) {
  const mcap::test::TemporaryFolder folder;
  {
    LogWriter log(folder / "x.mcap");
    const auto channel = log.add_channel("/pose", "geometry_msgs/msg/PoseStamped", "ros2msg",
                                         "Header header\nPoint point\n"
                                         "====\nMSG: std_msgs/Header\nint32 sec\nstring frame_id\n"
                                         "====\nMSG: geometry_msgs/Point\nfloat64 x\nfloat64 y\n");
    std::vector<std::uint8_t> bytes = {0, 1, 0, 0, 7, 0, 0, 0, 4, 0, 0, 0, 'm', 'a', 'p', 0};
    bytes.insert(bytes.end(), 4, 0);  // doubles stand at multiples of 8
    for (const double value : {1.5, -2.0}) {
      const auto* from = reinterpret_cast<const std::uint8_t*>(&value);
      bytes.insert(bytes.end(), from, from + sizeof(value));
    }
    log.write(channel, 5, bytes);
    log.close();
  }
  const Log log(folder / "x.mcap");
  std::ostringstream out;
  print_messages(log, Selection(log, {}), {true, {}}, out);
  EXPECT_THAT(out.str(), HasSubstr("\"value\":{\"header\": {\"sec\": 7, \"frame_id\": \"map\"}, "
                                   "\"point\": {\"x\": 1.5, \"y\": -2}}"));
}

TEST(RosMessage, AnEmptyOneHasTheMemberThatRosidlGivesIt) {
  EXPECT_THAT(idl_of("", "std_msgs/msg/Empty"), HasSubstr("structure_needs_at_least_one_member"));
}

TEST(RosMessage, WhatIsNoneIsRefusedWithItsLine) {
  EXPECT_EQ(refusal("int32 a\nOther b\n"), "line 2: no definition of a/Other");
  EXPECT_EQ(refusal("int32[x] a\n"), "line 1: 'x' is no number");
  EXPECT_EQ(refusal("int32[3 a\n"), "line 1: [ without ]");
  EXPECT_EQ(refusal("int32\n"), "line 1: no name");
  EXPECT_EQ(refusal("wstring a\n"), "line 1: wide strings are not read");
  EXPECT_EQ(refusal("a/B self\n"), "line 1: no definition of a/B") << "a type that holds itself";
}

}  // namespace
}  // namespace scarab::log::test
