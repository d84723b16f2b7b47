#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tools/drive/keys.hpp"
#include "tools/drive/line.hpp"

/// What the screen shows of the keyboard: the lines below the live state, and the pages that take
/// its place.
namespace scarab::drive {

/// Two or three lines: the keys, or the question that waits for an answer.
std::vector<Line> key_lines(const Keyboard& keyboard);

std::vector<Line> help_page();

/// The menu, scrolled so that the chosen entry shows in `rows`.
std::vector<Line> strategies_page(const Keyboard& keyboard,
                                  const std::vector<std::string>& strategies, std::size_t rows);

}  // namespace scarab::drive
