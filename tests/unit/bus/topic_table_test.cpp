// Holds idl/README.md and the IDL files against the code.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "common/bus/topics.hpp"

namespace scarab::bus {
namespace {

using testing::ElementsAreArray;

std::string read_file(const std::filesystem::path& path) {
  std::ifstream in(path);
  EXPECT_TRUE(in) << path;
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

template <class T>
std::string row_of(const Topic<T>& topic) {
  return std::string(topic.name) + " " + descriptor<T>().m_typename + " " +
         profile_name(topic.profile);
}

TEST(TopicTable, HasTheTopicsOfTheCode) {
  std::vector<std::string> declared;
  for_each_topic([&](const auto& topic) { declared.push_back(row_of(topic)); });

  const std::string readme =
      read_file(std::filesystem::path(SCARAB_SOURCE_DIR) / "idl" / "README.md");
  const std::regex row(R"(\| `(scarab/\w+)` \| `(scarab::\w+)` \| (\w+) \|)");
  std::vector<std::string> documented;
  for (std::sregex_iterator it(readme.begin(), readme.end(), row), end; it != end; ++it) {
    documented.push_back((*it)[1].str() + " " + (*it)[2].str() + " " + (*it)[3].str());
  }
  EXPECT_THAT(documented, ElementsAreArray(declared));
}

TEST(TopicTable, NamesEveryTopicThatTheHeaderDeclares) {
  const std::string header =
      read_file(std::filesystem::path(SCARAB_SOURCE_DIR) / "common" / "bus" / "topics.hpp");
  const std::regex declaration(R"re("scarab/\w+")re");
  const auto declared =
      std::distance(std::sregex_iterator(header.begin(), header.end(), declaration), {});
  std::ptrdiff_t listed = 0;
  for_each_topic([&](const auto&) { ++listed; });
  EXPECT_EQ(listed, declared);
}

struct IdlFile : testing::TestWithParam<std::string> {
  /// The file without comments.
  std::string text = std::regex_replace(
      read_file(std::filesystem::path(SCARAB_SOURCE_DIR) / "idl" / "scarab" / GetParam()),
      std::regex("//[^\n]*"), "");
};

TEST_P(IdlFile, HasNothingThatSomeReaderRefuses) {
  for (const char* refused :
       {"@optional", "@appendable", "@mutable", "pragma", "0x", "union", "bitmask", "bitset",
        "map<", "wstring", "wchar", "long double", "@value"}) {
    EXPECT_EQ(text.find(refused), std::string::npos) << refused;
  }
  EXPECT_FALSE(std::regex_search(text, std::regex(R"((^|[^\w])::\w)"))) << "absolute scope";
  EXPECT_FALSE(std::regex_search(text, std::regex(R"(struct\s+\w+\s*[:;])")))
      << "inheritance or forward declaration";
  EXPECT_FALSE(std::regex_search(text, std::regex(R"(const[^;]*=[^;]*[-+*/<>|&][^;]*;)")))
      << "computed constant";
}

TEST_P(IdlFile, DeclaresEveryStructFinal) {
  const std::regex structure(R"((@\w+\s+)?struct\s)");
  for (std::sregex_iterator it(text.begin(), text.end(), structure), end; it != end; ++it) {
    EXPECT_EQ((*it)[1].str(), "@final ");
  }
}

std::vector<std::string> idl_files() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(
           std::filesystem::path(SCARAB_SOURCE_DIR) / "idl" / "scarab")) {
    names.push_back(entry.path().filename());
  }
  std::sort(names.begin(), names.end());
  return names;
}

INSTANTIATE_TEST_SUITE_P(, IdlFile, testing::ValuesIn(idl_files()), [](const auto& file) {
  return file.param.substr(0, file.param.find('.'));
});

}  // namespace
}  // namespace scarab::bus
