#include "tools/topic/text_table.hpp"

#include <algorithm>
#include <numeric>

namespace scarab::topic {
namespace {

constexpr std::size_t kGap = 2;

}  // namespace

std::size_t shown_width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;  // not the rest of a character
  }));
}

std::string padded(const std::string& text, std::size_t width, bool right) {
  const std::size_t shown = shown_width(text);
  const std::string space(width > shown ? width - shown : 0, ' ');
  return right ? space + text : text + space;
}

std::vector<std::size_t> TextTable::widths() const {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    std::size_t width = shown_width(columns_[i].heading);
    for (const Row& row : rows_) width = std::max(width, shown_width(row.cells[i]));
    out.push_back(width);
  }
  return out;
}

std::size_t TextTable::width() const {
  const auto each = widths();
  return std::accumulate(each.begin(), each.end(), kGap * (each.size() - 1));
}

std::string TextTable::text() const {
  const auto each = widths();
  std::string out;
  const auto add_line = [&](const auto& cell) {
    std::string line;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      line += padded(cell(i), each[i], columns_[i].right) + std::string(kGap, ' ');
    }
    out += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  };
  add_line([&](std::size_t i) { return columns_[i].heading; });
  for (const Row& row : rows_) {
    add_line([&](std::size_t i) { return row.cells[i]; });
    for (const std::string& note : row.notes) out += note + "\n";
  }
  return out;
}

}  // namespace scarab::topic
