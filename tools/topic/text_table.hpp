#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace scarab::topic {

/// How many characters a text takes on a terminal: UTF-8 characters, each taken as one wide.
std::size_t shown_width(const std::string& text);

/// `text` with spaces after it (or before it, for numbers) up to a width.
std::string padded(const std::string& text, std::size_t width, bool right = false);

/// Lines of cells under a heading, each column as wide as its widest cell.
class TextTable {
 public:
  struct Column {
    std::string heading;
    bool right = false;  ///< numbers
  };

  explicit TextTable(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// One cell a column.
  void add(std::vector<std::string> cells) { rows_.push_back({std::move(cells), {}}); }
  /// A line below the last row, without columns.
  void add_note(const std::string& line) { rows_.back().notes.push_back(line); }

  /// Of the widest line, notes left out.
  std::size_t width() const;
  std::string text() const;

 private:
  struct Row {
    std::vector<std::string> cells;
    std::vector<std::string> notes;
  };
  std::vector<std::size_t> widths() const;

  std::vector<Column> columns_;
  std::vector<Row> rows_;
};

}  // namespace scarab::topic
