#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/unit/structure/include_rules.hpp"
#include "tests/unit/structure/text_rules.hpp"

/// The rules on the project's own files.
namespace scarab::structure {
namespace {

using testing::IsEmpty;
using Rule = Violations (*)(const SourceFile&);

const std::vector<SourceFile>& tree() {
  static const std::vector<SourceFile> kTree =
      read_tree(SCARAB_SOURCE_DIR, {"common", "services", "tools"});
  return kTree;
}

Violations violations_of(Rule rule) {
  Violations all;
  for (const SourceFile& file : tree()) {
    const Violations some = rule(file);
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

bool has(const std::string& path) {
  return std::any_of(tree().begin(), tree().end(),
                     [&](const SourceFile& file) { return file.path == path; });
}

TEST(Tree, IsTheWholeProject) {
  for (const char* path :
       {"common/bus/topics.hpp", "common/robot/joints.hpp", "services/plant/main.cpp",
        "services/premotor/main.cpp", "services/supervisor/main.cpp"}) {
    EXPECT_TRUE(has(path)) << path;
  }
}

TEST(Tree, PureCodeIncludesOnlyPureCode) {
  EXPECT_THAT(violations_of(check_pure_includes), IsEmpty());
}

TEST(Tree, PureCodeHasNoClockThreadLogOrGlobal) {
  EXPECT_THAT(violations_of(check_pure_text), IsEmpty());
}

TEST(Tree, OnlyTheBusIncludesDds) { EXPECT_THAT(violations_of(check_dds_includes), IsEmpty()); }

TEST(Tree, LibrariesStayAtHome) { EXPECT_THAT(violations_of(check_library_homes), IsEmpty()); }

TEST(Tree, LayersAreKept) { EXPECT_THAT(violations_of(check_layers), IsEmpty()); }

TEST(Tree, DriversOfARobotDoNotKnowEachOther) {
  EXPECT_THAT(violations_of(check_driver_includes), IsEmpty());
}

TEST(Tree, MainsAreSmallAndOnlyStartTheirService) {
  EXPECT_THAT(violations_of(check_main_includes), IsEmpty());
  EXPECT_THAT(violations_of(check_main_length), IsEmpty());
}

TEST(Tree, CoresConfigurationsAndMainsDoNotSeeTheIdl) {
  EXPECT_THAT(violations_of(check_idl_types), IsEmpty());
}

TEST(Tree, ControllersDoNotSeeTheGroundTruth) {
  EXPECT_THAT(violations_of(check_ground_truth), IsEmpty());
}

}  // namespace
}  // namespace scarab::structure
