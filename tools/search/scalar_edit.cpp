#include "tools/search/scalar_edit.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace scarab::search {
namespace {

constexpr std::string_view kBegin = "# Found by a parameter search:";
constexpr std::string_view kEnd = "# (written by scarab-search write)";

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// Keeps the comment that follows `end` in its column, `grown` characters having come before it.
void hold_comment(std::string& line, std::size_t end, std::ptrdiff_t grown) {
  const std::size_t hash = line.find('#', end);
  if (hash == std::string::npos) return;
  std::size_t blank = hash;
  while (blank > end && line[blank - 1] == ' ') --blank;
  const auto blanks = static_cast<std::ptrdiff_t>(hash - blank);
  const std::ptrdiff_t wanted =
      std::max<std::ptrdiff_t>(std::min<std::ptrdiff_t>(blanks, 2), blanks - grown);
  line.replace(blank, hash - blank, static_cast<std::size_t>(wanted), ' ');
}

void make(std::vector<std::string>& lines, const ScalarEdit& edit) {
  const auto row = static_cast<std::size_t>(edit.position.line) - 1;
  const auto column = static_cast<std::size_t>(edit.position.column) - 1;
  if (row >= lines.size() || column > lines[row].size() ||
      lines[row].compare(column, edit.before.size(), edit.before) != 0) {
    throw std::invalid_argument("line " + std::to_string(edit.position.line) + " does not have " +
                                edit.before);
  }
  std::string& line = lines[row];
  line.replace(column, edit.before.size(), edit.after);
  hold_comment(line, column + edit.after.size(),
               static_cast<std::ptrdiff_t>(edit.after.size()) -
                   static_cast<std::ptrdiff_t>(edit.before.size()));
}

bool begins_with(const std::string& line, std::string_view start) {
  return line.compare(0, start.size(), start) == 0;
}

}  // namespace

std::string edit_scalars(const std::string& text, std::vector<ScalarEdit> edits) {
  // From the end on: an edit moves what is behind it in its line.
  std::sort(edits.begin(), edits.end(), [](const ScalarEdit& a, const ScalarEdit& b) {
    return std::pair(a.position.line, a.position.column) >
           std::pair(b.position.line, b.position.column);
  });
  std::vector<std::string> lines = lines_of(text);
  for (const ScalarEdit& edit : edits) make(lines, edit);
  return joined(lines);
}

std::string with_provenance(const std::string& text, const std::vector<std::string>& lines) {
  std::vector<std::string> all = lines_of(text);
  const auto is = [](std::string_view start) {
    return [start](const std::string& line) { return begins_with(line, start); };
  };
  const auto begin = std::find_if(all.begin(), all.end(), is(kBegin));
  const auto end = std::find_if(begin, all.end(), is(kEnd));
  if (end != all.end()) all.erase(begin, end + 1);
  std::vector<std::string> block = {std::string(kBegin)};
  block.insert(block.end(), lines.begin(), lines.end());
  block.emplace_back(kEnd);
  all.insert(all.begin() + (all.empty() ? 0 : 1), block.begin(), block.end());
  return joined(all);
}

}  // namespace scarab::search
