#include "tests/unit/structure/source_file.hpp"

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace scarab::structure {
namespace {

/// Blanks comments and the content of string and character literals; keeps the line breaks. Raw
/// strings are taken for ordinary ones, which is enough for what the rules look for.
class Blanker {
 public:
  std::string operator()(const std::string& text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
      result += next(text[i], i + 1 < text.size() ? text[i + 1] : '\0');
    }
    return result;
  }

 private:
  enum class In { kCode, kLineComment, kBlockComment, kString, kCharacter };

  char next(char c, char following) {
    if (c == '\n') {
      if (in_ != In::kBlockComment) in_ = In::kCode;
      return previous_ = c;
    }
    const char shown = in_ == In::kCode ? in_code(c, following) : in_other(c);
    previous_ = previous_ == '\\' && c == '\\' ? '\0' : c;
    return shown;
  }

  char in_code(char c, char following) {
    if (c == '/' && following == '/') in_ = In::kLineComment;
    if (c == '/' && following == '*') in_ = In::kBlockComment;
    if (c == '"') in_ = In::kString;
    // A quote between digits or letters is a separator, such as in 10'000.
    const bool separates = std::isalnum(static_cast<unsigned char>(previous_)) != 0;
    if (c == '\'' && !separates) in_ = In::kCharacter;
    return in_ == In::kCode || c == '"' || c == '\'' ? c : ' ';
  }

  char in_other(char c) {
    const char quote = in_ == In::kString ? '"' : '\'';
    const bool is_literal = in_ == In::kString || in_ == In::kCharacter;
    if (is_literal && c == quote && previous_ != '\\') {
      in_ = In::kCode;
      return c;
    }
    if (in_ == In::kBlockComment && previous_ == '*' && c == '/') in_ = In::kCode;
    return ' ';
  }

  In in_ = In::kCode;
  char previous_ = '\0';
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The include on a line whose code says it is one.
bool parse_include(const std::string& code, const std::string& raw, Include& include) {
  const std::size_t hash = code.find_first_not_of(" \t");
  if (hash == std::string::npos || code[hash] != '#') return false;
  const std::size_t word = code.find_first_not_of(" \t", hash + 1);
  if (word == std::string::npos || code.compare(word, 7, "include") != 0) return false;
  const std::size_t open = raw.find_first_of("<\"", word);
  if (open == std::string::npos) return false;
  include.angled = raw[open] == '<';
  const std::size_t close = raw.find(include.angled ? '>' : '"', open + 1);
  if (close == std::string::npos) return false;
  include.target = raw.substr(open + 1, close - open - 1);
  return true;
}

bool is_source(const std::filesystem::path& path) {
  static const std::set<std::string> extensions = {".hpp", ".h", ".cpp"};
  return extensions.count(path.extension().string()) != 0;
}

}  // namespace

std::vector<std::string> parts_of(const std::string& path) {
  std::vector<std::string> parts;
  std::istringstream stream(path);
  for (std::string part; std::getline(stream, part, '/');) parts.push_back(part);
  return parts;
}

bool SourceFile::is_in(std::string_view folder) const {
  return path.size() > folder.size() && path.compare(0, folder.size(), folder) == 0 &&
         (folder.back() == '/' || path[folder.size()] == '/');
}

std::string SourceFile::part(std::size_t index) const {
  const std::vector<std::string> parts = parts_of(path);
  return index < parts.size() ? parts[index] : "";
}

std::string SourceFile::file_name() const { return parts_of(path).back(); }

SourceFile parse_source(std::string path, const std::string& text) {
  SourceFile file;
  file.path = std::move(path);
  file.code = lines_of(Blanker()(text));
  const std::vector<std::string> raw = lines_of(text);
  file.lines = static_cast<int>(raw.size());
  for (std::size_t i = 0; i < raw.size(); ++i) {
    Include include;
    include.line = static_cast<int>(i) + 1;
    if (parse_include(file.code[i], raw[i], include)) file.includes.push_back(include);
  }
  return file;
}

std::vector<SourceFile> read_tree(const std::filesystem::path& root,
                                  const std::vector<std::string>& folders) {
  std::vector<SourceFile> files;
  for (const std::string& folder : folders) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
      if (!entry.is_regular_file() || !is_source(entry.path())) continue;
      std::ifstream stream(entry.path(), std::ios::binary);
      std::ostringstream text;
      text << stream.rdbuf();
      if (!stream) throw std::runtime_error("cannot read " + entry.path().string());
      files.push_back(
          parse_source(entry.path().lexically_relative(root).generic_string(), text.str()));
    }
  }
  std::sort(files.begin(), files.end(),
            [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return files;
}

}  // namespace scarab::structure
