#include "tests/unit/structure/text_rules.hpp"

#include <cctype>
#include <string>
#include <vector>

namespace scarab::structure {
namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// `word` in `line`, not as a part of a longer word. A word that ends in '_' is the start of one.
bool has_word(const std::string& line, const std::string& word) {
  for (std::size_t at = line.find(word); at != std::string::npos; at = line.find(word, at + 1)) {
    const bool starts = at == 0 || !is_word(line[at - 1]);
    const std::size_t end = at + word.size();
    if (starts && (word.back() == '_' || end == line.size() || !is_word(line[end]))) return true;
  }
  return false;
}

Violations refuse_words(const SourceFile& file, const std::vector<std::string>& words,
                        const std::string& rule) {
  Violations violations;
  for (std::size_t i = 0; i < file.code.size(); ++i) {
    for (const std::string& word : words) {
      if (!has_word(file.code[i], word)) continue;
      std::string violation = file.path + ":" + std::to_string(i + 1);
      violation += ": " + word + ": " + rule;
      violations.push_back(violation);
    }
  }
  return violations;
}

/// A static or thread_local variable that is not constant, as far as one line tells: functions have
/// a bracket.
bool is_lasting_variable(const std::string& line) {
  if (!has_word(line, "static") && !has_word(line, "thread_local")) return false;
  return !has_word(line, "const") && !has_word(line, "constexpr") &&
         line.find('(') == std::string::npos;
}

}  // namespace

Violations check_pure_text(const SourceFile& file) {
  if (!is_pure(file)) return {};
  Violations violations = refuse_words(
      file,
      {"chrono", "thread", "mutex", "steady_clock", "system_clock", "spdlog", "cout", "cerr",
       "fprintf", "puts", "fopen", "getenv", "rand", "random_device", "scarab_"},
      "not in pure code");
  for (std::size_t i = 0; i < file.code.size(); ++i) {
    if (!is_lasting_variable(file.code[i])) continue;
    violations.push_back(file.path + ":" + std::to_string(i + 1) +
                         ": no global state in pure code");
  }
  return violations;
}

Violations check_idl_types(const SourceFile& file) {
  const std::string name = file.file_name();
  const bool is_service_room =
      file.is_in("services") && (name == "config.hpp" || name == "config.cpp");
  if (!is_pure(file) && !is_service_room && name != "main.cpp") return {};
  return refuse_words(file, {"scarab_"}, "types of the IDL are for adapters and services");
}

Violations check_ground_truth(const SourceFile& file) {
  const bool controls = file.is_in("services/supervisor") || file.is_in("services/premotor") ||
                        file.is_in("services/robot_bridge");
  const bool judges = file.path == "services/robot_bridge/referee_reader.cpp" ||
                      file.path == "services/robot_bridge/referee_reader.hpp";
  if (!controls || judges) return {};
  return refuse_words(file, {"scarab_WorldState", "kWorldState", "WorldTruth"},
                      "a controller sees only what a real robot measures");
}

Violations check_main_length(const SourceFile& file) {
  if (!file.is_in("services") || file.file_name() != "main.cpp" || file.lines < 60) return {};
  return {file.path + ": has " + std::to_string(file.lines) + " lines; main.cpp stays under 60"};
}

}  // namespace scarab::structure
