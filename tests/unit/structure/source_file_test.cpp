#include "tests/unit/structure/source_file.hpp"

#include <gtest/gtest.h>

namespace scarab::structure {
namespace {

TEST(SourceFile, FindsIncludesOfBothKinds) {
  const SourceFile file = parse_source(
      "common/a/b.hpp", "#pragma once\n#include <map>\n  #  include \"x/y.hpp\"  // why\n");
  ASSERT_EQ(file.includes.size(), 2U);
  EXPECT_EQ(file.includes[0].target, "map");
  EXPECT_TRUE(file.includes[0].angled);
  EXPECT_EQ(file.includes[0].line, 2);
  EXPECT_EQ(file.includes[1].target, "x/y.hpp");
  EXPECT_FALSE(file.includes[1].angled);
  EXPECT_EQ(file.lines, 3);
}

TEST(SourceFile, SeesNoIncludesInComments) {
  EXPECT_TRUE(
      parse_source("a.cpp", "// #include <map>\n/*\n#include <set>\n*/\n").includes.empty());
}

TEST(SourceFile, BlanksCommentsAndLiterals) {
  const SourceFile file = parse_source(
      "a.cpp",
      "int a; // thread\nauto b = \"thread \\\" thread\"; /* x\nthread */ int c = 10'000;\n");
  EXPECT_EQ(file.code[0].find("thread"), std::string::npos);
  EXPECT_EQ(file.code[1].find("thread"), std::string::npos);
  EXPECT_EQ(file.code[2].find("thread"), std::string::npos);
  EXPECT_NE(file.code[2].find("int c = 10'000;"), std::string::npos);
}

TEST(SourceFile, KnowsWhereItIs) {
  const SourceFile file = parse_source("services/plant/core/a.cpp", "");
  EXPECT_TRUE(file.is_in("services"));
  EXPECT_TRUE(file.is_in("services/plant"));
  EXPECT_FALSE(file.is_in("services/pla"));
  EXPECT_EQ(file.part(1), "plant");
  EXPECT_EQ(file.file_name(), "a.cpp");
}

}  // namespace
}  // namespace scarab::structure
