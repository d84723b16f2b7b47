#include "tests/unit/structure/text_rules.hpp"

#include <gtest/gtest.h>

#include <string>

namespace scarab::structure {
namespace {

std::size_t pure_violations(const std::string& code) {
  return check_pure_text(parse_source("services/plant/core/a.cpp", code)).size();
}

TEST(PureText, CatchesClocksThreadsConsoleAndChance) {
  EXPECT_EQ(pure_violations("auto now = std::chrono::steady_clock::now();"), 2U);
  EXPECT_EQ(pure_violations("std::thread t;"), 1U);
  EXPECT_EQ(pure_violations("std::cout << 1;"), 1U);
  EXPECT_EQ(pure_violations("std::fprintf(stderr, text);"), 1U);
  EXPECT_EQ(pure_violations("std::snprintf(text, 9, format);"), 0U) << "only formats";
  EXPECT_EQ(pure_violations("int r = rand();"), 1U);
  EXPECT_EQ(pure_violations("const char* home = std::getenv(\"HOME\");"), 1U);
  EXPECT_EQ(pure_violations("scarab_RobotState state;"), 1U);
}

TEST(PureText, CatchesGlobalState) {
  EXPECT_EQ(pure_violations("static int counter = 0;"), 1U);
  EXPECT_EQ(pure_violations("thread_local std::vector<int> cache;"), 1U);
  EXPECT_EQ(pure_violations("static const int kLimit = 3;"), 0U);
  EXPECT_EQ(pure_violations("static constexpr int kLimit = 3;"), 0U);
  EXPECT_EQ(pure_violations("static int square(int x);"), 0U);
}

TEST(PureText, LeavesCommentsLongerWordsAndOtherFilesAlone) {
  EXPECT_EQ(pure_violations("// a synchronous update, no thread\n"), 0U);
  EXPECT_EQ(pure_violations("int threads = 1; double operand = rand_;"), 0U);
  EXPECT_TRUE(
      check_pure_text(parse_source("services/plant/service.cpp", "std::thread t;")).empty());
}

TEST(IdlTypes, AreForAdaptersAndServices) {
  const std::string code = "scarab_RobotState state;";
  EXPECT_FALSE(check_idl_types(parse_source("services/plant/core/a.hpp", code)).empty());
  EXPECT_FALSE(check_idl_types(parse_source("services/plant/config.cpp", code)).empty());
  EXPECT_FALSE(check_idl_types(parse_source("services/plant/main.cpp", code)).empty());
  EXPECT_TRUE(check_idl_types(parse_source("services/plant/adapter.cpp", code)).empty());
  EXPECT_TRUE(check_idl_types(parse_source("services/plant/service.cpp", code)).empty());
}

TEST(GroundTruth, IsNotForControllers) {
  const std::string code = "bus::Reader<scarab_WorldState> reader(p, bus::kWorldState);";
  EXPECT_EQ(check_ground_truth(parse_source("services/supervisor/service.cpp", code)).size(), 2U);
  EXPECT_EQ(check_ground_truth(parse_source("services/premotor/adapter.hpp", code)).size(), 2U);
  EXPECT_EQ(check_ground_truth(parse_source("services/robot_bridge/bridge_body.cpp", code)).size(),
            2U);
  EXPECT_TRUE(
      check_ground_truth(parse_source("services/robot_bridge/referee_reader.hpp", code)).empty());
  EXPECT_TRUE(check_ground_truth(parse_source("services/experiment/service.cpp", code)).empty());
}

TEST(MainLength, IsUnderSixty) {
  const std::string line = "int x;\n";
  std::string text;
  for (int i = 0; i < 59; ++i) text += line;
  EXPECT_TRUE(check_main_length(parse_source("services/a/main.cpp", text)).empty());
  EXPECT_FALSE(check_main_length(parse_source("services/a/main.cpp", text + line)).empty());
  EXPECT_TRUE(check_main_length(parse_source("services/a/service.cpp", text + line)).empty());
}

}  // namespace
}  // namespace scarab::structure
