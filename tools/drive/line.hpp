#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// Text of a screen, before any terminal.
namespace scarab::drive {

enum class Style { kPlain, kDim, kBold, kGood, kWarning, kAlarm, kSelected };

struct Span {
  std::string text;
  Style style = Style::kPlain;
};
using Line = std::vector<Span>;

/// The characters of a line without their styles.
std::string plain(const Line& line);

/// One row of text for any terminal: control characters, which could do anything to it, become '?',
/// and what is wider than `columns` is cut between two UTF-8 characters. A character counts as one
/// column.
std::string fit(const std::string& text, std::size_t columns);

/// The same, filled up with spaces.
std::string padded(const std::string& text, std::size_t columns);

/// Columns a text takes.
std::size_t width(const std::string& text);

/// The line cut to `columns`.
Line fit(const Line& line, std::size_t columns);

/// "[####|  ]": filled from `low` up to `value`, with a '|' at `mark`. `columns` with the brackets,
/// at least 3; a value that is not finite fills nothing.
std::string bar(double value, double low, double high, double mark, std::size_t columns);

/// "[  ##|    ]": filled from 0, in the middle, to `value` of -1..1.
std::string signed_bar(double value, std::size_t columns);

/// A number with its sign and so many decimals; "-" if it is not finite.
std::string figure(double value, int decimals);

}  // namespace scarab::drive
