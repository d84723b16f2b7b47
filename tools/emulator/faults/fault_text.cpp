#include "tools/emulator/faults/fault_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "common/robot/joints.hpp"

namespace scarab::emulator {
namespace {

/// What stands behind a fault's word.
enum class Operands { kNone, kValue, kJoint, kJointValue, kPart };

struct Word {
  std::string_view name;
  FaultKind kind;
  Operands operands;
  double least, most;  // of the value
  std::string_view synopsis;
  std::string_view meaning;
};

constexpr double kNever = 1e6;  // s; longer than anybody waits

constexpr std::array<Word, 10> kWords = {{
    {"lose", FaultKind::kLose, Operands::kValue, 0, 1, "lose P",
     "each byte is lost with this probability, both ways"},
    {"flip", FaultKind::kFlip, Operands::kValue, 0, 1, "flip P",
     "a bit of each byte flips with this probability, both ways"},
    {"stuck", FaultKind::kStuck, Operands::kJoint, 0, 0, "stuck JOINT",
     "this servo holds where it is, whatever its goal"},
    {"silent", FaultKind::kSilent, Operands::kPart, 0, 0, "silent JOINT|imu|board",
     "neither hears nor answers"},
    {"late", FaultKind::kLate, Operands::kValue, 0, 60, "late S",
     "answers come so many seconds later"},
    {"unplug", FaultKind::kUnplug, Operands::kNone, 0, 0, "unplug", "the device is gone"},
    {"hot", FaultKind::kHot, Operands::kJointValue, -20, 150, "hot JOINT C",
     "this servo's temperature"},
    {"current", FaultKind::kCurrent, Operands::kJointValue, -10, 10, "current JOINT A",
     "this servo draws so much more"},
    {"tilt", FaultKind::kTilt, Operands::kValue, -3.2, 3.2, "tilt RAD",
     "added to the pitch that the robot measures"},
    {"pose", FaultKind::kPose, Operands::kJointValue, -3.2, 3.2, "pose JOINT RAD",
     "where this joint stands when the next trial begins"},
}};

const Word& word_of(FaultKind kind) {
  return *std::find_if(kWords.begin(), kWords.end(),
                       [kind](const Word& word) { return word.kind == kind; });
}

std::vector<std::string_view> words_in(std::string_view line) {
  constexpr std::string_view kBlank = " \t\r\n";
  std::vector<std::string_view> words;
  std::size_t at = line.find_first_not_of(kBlank);
  while (at != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(kBlank, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(kBlank, end);
  }
  return words;
}

[[noreturn]] void refuse(const std::string& why) { throw std::invalid_argument(why); }

/// The words of one line, taken from the front.
class Line {
 public:
  explicit Line(std::string_view text) : words_(words_in(text)) {}

  [[nodiscard]] bool at_end() const { return next_ == words_.size(); }
  std::string_view take(std::string_view missing) {
    if (at_end()) refuse(std::string(missing));
    return words_[next_++];
  }
  bool take_if(std::string_view word) {
    if (at_end() || words_[next_] != word) return false;
    ++next_;
    return true;
  }
  double number(const std::string& name, double least, double most) {
    const std::string_view text = take(name + " needs a number");
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
      refuse(fmt::format("{}: '{}' is no number", name, text));
    }
    if (value < least || value > most) {
      refuse(fmt::format("{}: {} is not between {} and {}", name, text, least, most));
    }
    return value;
  }
  std::size_t joint(const std::string& name) {
    const std::string_view text = take(name + " needs a joint, such as TR0");
    const auto found = std::find(robot::kJointNames.begin(), robot::kJointNames.end(), text);
    if (found == robot::kJointNames.end()) {
      refuse(fmt::format("{}: there is no joint '{}' (TL0 .. FR2, BJ)", name, text));
    }
    return static_cast<std::size_t>(found - robot::kJointNames.begin());
  }

 private:
  std::vector<std::string_view> words_;
  std::size_t next_ = 0;
};

void take_part(Line& line, Fault& fault) {
  if (line.take_if("imu")) {
    fault.part = SilentPart::kImu;
  } else if (line.take_if("board")) {
    fault.part = SilentPart::kBoard;
  } else {
    fault.part = SilentPart::kJoint;
    if (line.at_end()) refuse("silent needs a joint, such as TR0, or imu or board");
    fault.joint = line.joint("silent");
  }
}

Fault take_fault(Line& line, const Word& word) {
  const std::string name(word.name);
  Fault fault;
  fault.kind = word.kind;
  if (word.operands == Operands::kPart) take_part(line, fault);
  if (word.operands == Operands::kJoint || word.operands == Operands::kJointValue) {
    fault.joint = line.joint(name);
  }
  if (word.operands == Operands::kValue || word.operands == Operands::kJointValue) {
    fault.value = line.number(name, word.least, word.most);
  }
  if (line.take_if("at")) fault.at_s = line.number(name + " at", 0, kNever);
  if (line.take_if("for")) fault.for_s = line.number(name + " for", 0, kNever);
  return fault;
}

}  // namespace

FaultOrder parse_fault_order(std::string_view text) {
  Line line(text);
  const std::string_view name = line.take("an empty line is no fault");
  FaultOrder order = Clear{};
  if (name != "clear") {
    const auto found = std::find_if(kWords.begin(), kWords.end(),
                                    [name](const Word& word) { return word.name == name; });
    if (found == kWords.end()) {
      std::string known;
      for (const Word& word : kWords) known += std::string(word.name) + ", ";
      refuse(fmt::format("there is no fault '{}'; there are {}and clear", name, known));
    }
    order = take_fault(line, *found);
  }
  if (!line.at_end()) {
    refuse(fmt::format("{}: '{}' does not belong there", name, line.take("")));
  }
  return order;
}

std::string to_text(const Fault& fault) {
  const Word& word = word_of(fault.kind);
  std::string text(word.name);
  const bool has_joint = word.operands == Operands::kJoint ||
                         word.operands == Operands::kJointValue ||
                         (word.operands == Operands::kPart && fault.part == SilentPart::kJoint);
  if (has_joint) text += fmt::format(" {}", robot::kJointNames.at(fault.joint));
  if (word.operands == Operands::kPart && fault.part == SilentPart::kImu) text += " imu";
  if (word.operands == Operands::kPart && fault.part == SilentPart::kBoard) text += " board";
  if (word.operands == Operands::kValue || word.operands == Operands::kJointValue) {
    text += fmt::format(" {}", fault.value);
  }
  if (fault.at_s) text += fmt::format(" at {}", *fault.at_s);
  if (fault.for_s) text += fmt::format(" for {}", *fault.for_s);
  return text;
}

std::string fault_words_help() {
  std::string help;
  for (const Word& word : kWords) help += fmt::format("  {:<24} {}\n", word.synopsis, word.meaning);
  help += fmt::format("  {:<24} {}\n", "clear", "none of these any more");
  help += "  each may end with `at S` (since the world's t = 0) and `for S`\n";
  return help;
}

}  // namespace scarab::emulator
