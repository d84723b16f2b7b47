#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "common/config/error.hpp"
#include "common/config/robot_file.hpp"
#include "common/random/random.hpp"
#include "tests/unit/config/error_line.hpp"
#include "tests/unit/config/gait.hpp"

/// Random damage to real files: it either still loads or is refused in one well-formed line; it
/// never crashes and never throws anything else.
namespace scarab::config {
namespace {

constexpr std::uint64_t kMutations = 3000;

std::string read_file(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Dice of one mutation.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : seed_(seed) {}
  std::size_t below(std::size_t end) {
    return static_cast<std::size_t>(random::bits(seed_, random::stream("mutation"), index_++) %
                                    end);
  }

 private:
  std::uint64_t seed_;
  std::uint64_t index_ = 0;
};

/// Cuts, doubles or moves a piece, or puts in something that YAML gives a meaning.
std::string mutated(std::string text, Dice& dice) {
  static const std::vector<std::string> kSnippets = {
      ":",    "\n", "- ",          "[",    "]",        "{",
      "}",    "\t", "&a ",         "*a",   "!!float ", "|\n",
      ">",    "'",  "\"",          "#",    "? ",       "---",
      "...",  "~",  "nan",         ".inf", "-",        "1e999",
      "0x",   "\\", "%YAML 1.1\n", "\xff", "\xc3",     std::string(1, '\0'),
      "<<: ", ", ", "absent",      "  "};
  const std::size_t edits = 1 + dice.below(4);
  for (std::size_t i = 0; i < edits && !text.empty(); ++i) {
    const std::size_t at = dice.below(text.size());
    const std::size_t length = 1 + dice.below(30);
    const std::string piece = text.substr(at, length);
    switch (dice.below(4)) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(dice.below(text.size()), piece);
        break;
      case 2:
        text.insert(at, kSnippets[dice.below(kSnippets.size())]);
        break;
      default:
        text[at] = static_cast<char>(dice.below(256));
    }
  }
  return text;
}

/// Counts of loaded and refused files; every refusal is checked.
template <class Load>
std::pair<int, int> survive(const std::string& original, const Load& load) {
  std::pair<int, int> loaded_refused{0, 0};
  for (std::uint64_t seed = 0; seed < kMutations; ++seed) {
    Dice dice(seed);
    const std::string text = mutated(original, dice);
    try {
      load(text);
      ++loaded_refused.first;
    } catch (const Error& error) {
      EXPECT_TRUE(key_and_reason(error.what(), "m.yaml")) << error.what();
      ++loaded_refused.second;
    }
  }
  return loaded_refused;
}

TEST(Mutation, OfTheRobotFileLoadsOrIsRefused) {
  const std::string original = read_file(SCARAB_SOURCE_DIR "/config/robot/beetle.yaml");
  const auto [loaded, refused] =
      survive(original, [](const std::string& text) { (void)load_robot_text("m.yaml", text); });
  EXPECT_GT(loaded, 100) << "most of a file is comments";
  EXPECT_GT(refused, 1000);
}

TEST(Mutation, OfEveryShippedFileParsesOrIsRefused) {
  int files = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(SCARAB_SOURCE_DIR "/config")) {
    if (entry.path().extension() != ".yaml") continue;
    ++files;
    const auto [parsed, refused] =
        survive(read_file(entry.path().string()),
                [](const std::string& text) { (void)parse_text("m.yaml", text); });
    EXPECT_GT(parsed, 100) << entry.path();
    EXPECT_GT(refused, 100) << entry.path();
  }
  EXPECT_GE(files, 4);
}

TEST(Mutation, OfEveryKindOfMemberLoadsOrIsRefusedAndDumps) {
  const auto [loaded, refused] = survive(gait::kGood, [](const std::string& text) {
    const std::string dumped = dump(load_text<gait::Gait>("m.yaml", text));
    EXPECT_EQ(dump(load_text<gait::Gait>("dump", dumped)), dumped) << text;
  });
  EXPECT_GT(loaded, 20);
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace scarab::config
