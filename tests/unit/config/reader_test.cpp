#include "common/config/reader.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "tests/unit/config/gait.hpp"

namespace scarab::gait {
namespace {

/// kGood with one line (from 1) replaced; an empty one is left out.
std::string good_but(int line, const std::string& replacement) {
  std::string result;
  std::istringstream lines(kGood);
  int number = 0;
  for (std::string text; std::getline(lines, text);) {
    if (++number != line) {
      result += text + "\n";
    } else if (!replacement.empty()) {
      result += replacement + "\n";
    }
  }
  return result;
}

std::string error_of(const std::string& text) {
  try {
    (void)config::load_text<Gait>("gait.yaml", text);
  } catch (const config::Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Reader, FillsEveryKindOfMember) {
  const auto gait = config::load_text<Gait>("gait.yaml", kGood);
  EXPECT_EQ(gait.name, "walk");
  EXPECT_EQ(gait.kind, Kind::kWave);
  EXPECT_EQ(gait.frequency_hz, 1.5);
  EXPECT_EQ(gait.offset, -2);
  EXPECT_EQ(gait.legs, 2U);
  EXPECT_EQ(gait.seed, 18446744073709551615ULL);
  EXPECT_EQ(gait.phases, (std::array<double, 3>{0, 0.25, 0.5}));
  EXPECT_EQ(gait.weights[0], 1e-3);
  EXPECT_EQ(gait.weights[1], -2);
  EXPECT_EQ(gait.order, (std::vector<int>{2, 1}));
  ASSERT_EQ(gait.parts.size(), 2U);
  EXPECT_EQ(gait.parts.at("left").length_m, 0.3);
  EXPECT_FALSE(gait.parts.at("right").present);
  EXPECT_FALSE(gait.tail.has_value());
  ASSERT_EQ(gait.spares.size(), 1U);
  EXPECT_TRUE(gait.spares[0].present);
  EXPECT_EQ(gait.trim, 0.25) << "left out: its default";
}

TEST(Reader, ReadsWhatIsOptionalWhereItIsGiven) {
  const std::string text = good_but(15, "tail: {length_m: 0.2, present: true}") + "trim: -0.5\n";
  const auto gait = config::load_text<Gait>("gait.yaml", text);
  ASSERT_TRUE(gait.tail.has_value());
  EXPECT_EQ(gait.tail->length_m, 0.2);
  EXPECT_EQ(gait.trim, -0.5);
}

struct BadInput {
  const char* what;
  int line;
  const char* replacement;
  const char* error;
};

void PrintTo(const BadInput& input, std::ostream* out) { *out << input.what; }

class BadInputTest : public testing::TestWithParam<BadInput> {};

TEST_P(BadInputTest, IsOneLineThatSaysWhereAndWhy) {
  EXPECT_EQ(error_of(good_but(GetParam().line, GetParam().replacement)), GetParam().error);
}

const BadInput kBadInputs[] = {
    {"unknown key", 3, "frequenzy_hz: 1.5",
     "gait.yaml:3:1: frequenzy_hz: unknown key; did you mean 'frequency_hz'?"},
    {"blank line", 4, "  ", "gait.yaml:1:1: offset: missing key"},
    {"unknown nested key", 13, "    lenght_m: 0.4",
     "gait.yaml:13:5: parts.right.lenght_m: unknown key; did you mean 'length_m'?"},
    {"unknown key in a list", 17, "  - {length_m: 0.1, colour: red}",
     "gait.yaml:17:21: spares[0].colour: unknown key; known here: length_m, present"},
    {"duplicate key", 2, "name: run", "gait.yaml:2:1: name: duplicate key, first given in line 1"},
    {"duplicate nested key", 14, "    length_m: 0.4",
     "gait.yaml:14:5: parts.right.length_m: duplicate key, first given in line 13"},
    {"duplicate key on one line", 11, "  left: {present: true, present: true}",
     "gait.yaml:11:25: parts.left.present: duplicate key, first given in line 11"},
    {"missing key", 3, "", "gait.yaml:1:1: frequency_hz: missing key"},
    {"missing nested key", 14, "", "gait.yaml:13:5: parts.right.present: missing key"},
    {"text for a number", 3, "frequency_hz: fast",
     "gait.yaml:3:15: frequency_hz: expected a number, found 'fast'"},
    {"quoted number", 3, "frequency_hz: '1.5'",
     "gait.yaml:3:15: frequency_hz: expected a number, found the text '1.5'"},
    {"nothing for a number", 3,
     "frequency_hz:", "gait.yaml:3:1: frequency_hz: expected a number, found nothing"},
    {"list for a number", 3, "frequency_hz: [1]",
     "gait.yaml:3:15: frequency_hz: expected a number, found a list"},
    {"map for a number", 3, "frequency_hz: {a: 1}",
     "gait.yaml:3:15: frequency_hz: expected a number, found a map"},
    {"fraction for a whole number", 4, "offset: 1.5",
     "gait.yaml:4:9: offset: expected a whole number, found '1.5'"},
    {"negative for unsigned", 5, "legs: -1", "gait.yaml:5:7: legs: -1 is negative"},
    {"too large for the type", 4, "offset: 3000000000",
     "gait.yaml:4:9: offset: 3000000000 is not in [-2147483648, 2147483647]"},
    {"too large for any type", 6, "seed: 18446744073709551616",
     "gait.yaml:6:7: seed: '18446744073709551616' is beyond what the type can hold"},
    {"above the range", 3, "frequency_hz: 5.01",
     "gait.yaml:3:15: frequency_hz: 5.01 is not in [0.1, 5]"},
    {"below the range", 3, "frequency_hz: 0.0999",
     "gait.yaml:3:15: frequency_hz: 0.0999 is not in [0.1, 5]"},
    {"whole number above the range", 5, "legs: 9", "gait.yaml:5:7: legs: 9 is not in [0, 8]"},
    {"element out of range", 7, "phases: [0, 1.5, 0]",
     "gait.yaml:7:13: phases[1]: 1.5 is not in [0, 1]"},
    {"at an open end of the range", 13, "    length_m: 0",
     "gait.yaml:13:15: parts.right.length_m: 0 is not above 0"},
    {"nan", 3, "frequency_hz: .nan", "gait.yaml:3:15: frequency_hz: '.nan' is not finite"},
    {"nan in a list", 8, "weights: [1, NaN]", "gait.yaml:8:14: weights[1]: 'NaN' is not finite"},
    {"infinity", 3, "frequency_hz: -.inf", "gait.yaml:3:15: frequency_hz: '-.inf' is not finite"},
    {"overflow", 8, "weights: [1, 1e999]",
     "gait.yaml:8:14: weights[1]: '1e999' is beyond what the type can hold"},
    {"octal", 4, "offset: 010",
     "gait.yaml:4:9: offset: '010' has a leading zero, which YAML reads as octal; write it "
     "without"},
    {"octal for a double", 3, "frequency_hz: 01.5",
     "gait.yaml:3:15: frequency_hz: '01.5' has a leading zero, which YAML reads as octal; write it "
     "without"},
    {"hexadecimal", 4, "offset: 0x10",
     "gait.yaml:4:9: offset: expected a whole number, found '0x10'"},
    {"truth by another name", 14, "    present: yes",
     "gait.yaml:14:14: parts.right.present: expected true or false, found 'yes'"},
    {"unknown name", 2, "kind: tripot",
     "gait.yaml:2:7: kind: expected one of tripod, tetrapod, wave, found 'tripot'; did you mean "
     "'tripod'?"},
    {"list for a name", 2, "kind: [wave]",
     "gait.yaml:2:7: kind: expected one of tripod, tetrapod, wave, found a list"},
    {"number for a list", 7, "phases: 0.5",
     "gait.yaml:7:9: phases: expected a list of 3, found '0.5'"},
    {"short list", 7, "phases: [0.5]",
     "gait.yaml:7:9: phases: expected a list of 3, found 1 element"},
    {"long list", 8, "weights: [1, 2, 3]",
     "gait.yaml:8:10: weights: expected a list of 2, found 3 elements"},
    {"map for a text", 1, "name: {a: b}", "gait.yaml:1:7: name: expected text, found a map"},
    {"scalar for a struct", 15, "tail: none",
     "gait.yaml:15:7: tail: expected a map with the keys length_m, present, found 'none'"},
    {"condition between keys", 9, "order: [2, 1, 3]",
     "gait.yaml:9:8: order: needs one entry for each leg"},
    {"condition on a nested key", 13, "    length_m: 1.4",
     "gait.yaml:13:15: parts.right.length_m: longer than the robot"},
    {"syntax", 9, "order: [2, 1", "gait.yaml:10:6: (syntax): end of sequence flow not found"},
    {"tab", 13, "\tlength_m: 0.4",
     "gait.yaml:13:2: (syntax): end of map not found; the line is indented with a tab, use spaces"},
    {"anchor", 3, "frequency_hz: &f 1.5",
     "gait.yaml:3:15: frequency_hz: anchors are not supported; write the value out"},
    {"tag", 3, "frequency_hz: !hz 1.5", "gait.yaml:3:15: frequency_hz: tags are not supported"},
    {"key that is no text", 3, "[a, b]: 1", "gait.yaml:3:1: (top level): a key must be text"},
    {"control character", 3, "frequency_hz: \"1\\n2\"",
     "gait.yaml:3:15: frequency_hz: expected a number, found the text '1?2'"},
};

INSTANTIATE_TEST_SUITE_P(EveryKind, BadInputTest, testing::ValuesIn(kBadInputs),
                         [](const testing::TestParamInfo<BadInput>& bad) {
                           std::string name = bad.param.what;
                           for (char& c : name) c = c == ' ' ? '_' : c;
                           return name;
                         });

TEST(Reader, ShortensLongTextInErrors) {
  const std::string error = error_of(good_but(2, "kind: " + std::string(10'000, 'x')));
  EXPECT_LT(error.size(), 200U);
}

TEST(Reader, MissingFileIsNamed) {
  try {
    (void)config::load<Gait>("no/such/gait.yaml");
    FAIL() << "loaded a file that is not there";
  } catch (const config::Error& error) {
    EXPECT_STREQ(error.what(), "no/such/gait.yaml:1:1: (file): No such file or directory");
  }
}

TEST(Reader, DirectoryIsNotAFile) {
  const std::string directory = SCARAB_SOURCE_DIR "/config";
  try {
    (void)config::load<Gait>(directory);
    FAIL() << "loaded a directory";
  } catch (const config::Error& error) {
    EXPECT_EQ(error.what(), directory + ":1:1: (file): is a directory");
  }
}

}  // namespace
}  // namespace scarab::gait
