#include "tools/drive/pages.hpp"

#include <algorithm>

namespace scarab::drive {
namespace {

const char* const kEmergencyHint = "SPACE is the emergency stop here, too";

}  // namespace

std::vector<Line> key_lines(const Keyboard& keyboard) {
  if (keyboard.page == Page::kConfirmReset) {
    return {
        {{" Leave the safe stop? The robot homes first. ", Style::kAlarm}, {" y: yes  else: no"}},
        {{kEmergencyHint, Style::kDim}}};
  }
  if (keyboard.page == Page::kConfirmStop) {
    return {
        {{" End the trial? Its verdict is then a failure. ", Style::kAlarm}, {" y: yes  else: no"}},
        {{kEmergencyHint, Style::kDim}}};
  }
  return {{{"SPACE EMERGENCY STOP", Style::kAlarm},
           {"  r reset  p pause  g go  n next tick  ? help  q quit"}},
          {{"mode: o stop  f forward  b backward  s soft  x boxing  i stationary  h hard"}},
          {{"a automatic  m strategies  1-4 and up/down: inputs  t trial  e end the trial"}}};
}

std::vector<Line> help_page() {
  std::vector<Line> lines = {{{"Keys", Style::kBold}}};
  for (const auto& entry : key_help()) {
    lines.push_back({{padded(entry.key, 9), Style::kBold}, {entry.does}});
  }
  lines.push_back({{"Any key goes back. ", Style::kDim}, {kEmergencyHint, Style::kDim}});
  return lines;
}

std::vector<Line> strategies_page(const Keyboard& keyboard,
                                  const std::vector<std::string>& strategies, std::size_t rows) {
  std::vector<Line> lines = {
      {{"Strategies", Style::kBold}, {"  up, down: choose   Enter: follow it   Escape: back"}},
      {{kEmergencyHint, Style::kDim}}};
  if (strategies.empty()) {
    lines.push_back({{"none given: start with --strategies A,B,C", Style::kWarning}});
    return lines;
  }
  const std::size_t room = rows - lines.size();
  const std::size_t first = keyboard.menu_entry < room ? 0 : keyboard.menu_entry - room + 1;
  for (std::size_t i = first; i < std::min(strategies.size(), first + room); ++i) {
    const bool chosen = i == keyboard.menu_entry;
    lines.push_back({{(chosen ? " > " : "   ") + strategies[i] + " ",
                      chosen ? Style::kSelected : Style::kPlain}});
  }
  return lines;
}

}  // namespace scarab::drive
