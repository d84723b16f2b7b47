#pragma once

#include <string>
#include <vector>

#include "tools/drive/keys.hpp"
#include "tools/drive/line.hpp"
#include "tools/drive/live.hpp"

namespace scarab::drive {

struct Size {
  std::size_t columns = 0;
  std::size_t rows = 0;
};

/// What the screen needs.
inline constexpr Size kSmallest{80, 24};

/// The last thing said and what became of it, or why it was not said.
struct Notice {
  std::string text;
  Concern concern = Concern::kNone;
};

/// The whole screen, row by row, each inside `size`. A screen smaller than kSmallest only says so.
std::vector<Line> draw(const Live& live, const Keyboard& keyboard,
                       const std::vector<std::string>& strategies, const Notice& notice, Size size);

/// In words that a screen is too small, short enough for most that are.
std::string too_small(Size size);

}  // namespace scarab::drive
