#include "tools/drive/line.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace scarab::drive {
namespace {

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20U || c == 0x7F; }

/// Where in 0..places a value lies.
std::size_t place(double value, double low, double high, std::size_t places) {
  const double share = std::clamp((value - low) / (high - low), 0.0, 1.0);
  return static_cast<std::size_t>(std::lround(share * static_cast<double>(places)));
}

}  // namespace

std::string plain(const Line& line) {
  std::string text;
  for (const Span& span : line) text += span.text;
  return text;
}

std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return !continues(c); }));
}

std::string fit(const std::string& text, std::size_t columns) {
  std::string fitted;
  std::size_t used = 0;
  for (const char c : text) {
    if (!continues(c) && ++used > columns) break;
    fitted += is_control(c) ? '?' : c;
  }
  return fitted;
}

std::string padded(const std::string& text, std::size_t columns) {
  const std::string fitted = fit(text, columns);
  return fitted + std::string(columns - width(fitted), ' ');
}

Line fit(const Line& line, std::size_t columns) {
  Line fitted;
  for (const Span& span : line) {
    fitted.push_back({fit(span.text, columns), span.style});
    columns -= width(fitted.back().text);
  }
  return fitted;
}

std::string bar(double value, double low, double high, double mark, std::size_t columns) {
  const std::size_t places = std::max<std::size_t>(columns, 3) - 2;
  std::string inside(places, ' ');
  if (std::isfinite(value)) {
    const auto filled = static_cast<std::ptrdiff_t>(place(value, low, high, places));
    std::fill(inside.begin(), inside.begin() + filled, '#');
  }
  inside[std::min(places - 1, place(mark, low, high, places))] = '|';
  return "[" + inside + "]";
}

std::string signed_bar(double value, std::size_t columns) {
  const std::size_t half = (std::max<std::size_t>(columns, 5) - 3) / 2;
  std::string left(half, ' ');
  std::string right(half, ' ');
  if (std::isfinite(value)) {
    const std::size_t filled = place(std::abs(value), 0, 1, half);
    std::string& side = value < 0 ? left : right;
    side.replace(value < 0 ? half - filled : 0, filled, filled, '#');
  }
  return "[" + left + "|" + right + "]";
}

std::string figure(double value, int decimals) {
  if (!std::isfinite(value)) return "-";
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%+.*f", decimals, value);
  return text.data();
}

}  // namespace scarab::drive
