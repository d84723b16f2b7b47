#include "tools/drive/keys.hpp"

#include <algorithm>
#include <cmath>

namespace scarab::drive {
namespace {

using supervisor::Mode;
using Command = supervisor::OperatorWord::Command;

constexpr double kInputStep = 0.1;

struct ModeKey {
  char key;
  Mode mode;
};
constexpr std::array<ModeKey, 7> kModeKeys = {{{'o', Mode::kStop},
                                               {'f', Mode::kForward},
                                               {'b', Mode::kBackward},
                                               {'s', Mode::kSoftPush},
                                               {'x', Mode::kBoxing},
                                               {'i', Mode::kStationary},
                                               {'h', Mode::kHardPush}}};

/// Keys that say one thing to the tick master.
struct MasterKey {
  char key;
  const char* name;
  scarab_OperatorCommand command;
  const char* does;
};
constexpr std::array<MasterKey, 3> kMasterKeys = {
    {{'p', "pause", scarab_OPERATOR_PAUSE, "pause the trial"},
     {'g', "start", scarab_OPERATOR_START, "go on after a pause"},
     {'n', "step", scarab_OPERATOR_STEP, "the next tick alone, then pause"}}};

/// Keys that open a page.
struct PageKey {
  char key;
  Page page;
  const char* does;
};
constexpr std::array<PageKey, 4> kPageKeys = {
    {{'r', Page::kConfirmReset, "reset: leave the safe stop, through homing (asks first)"},
     {'e', Page::kConfirmStop, "end the trial (asks first)"},
     {'m', Page::kStrategies, "menu of the strategies"},
     {'?', Page::kHelp, "this help"}}};

bool is(Key key, char character) { return static_cast<int>(key) == character; }

Action say(scarab_OperatorCommand command, const std::string& name,
           const supervisor::OperatorWord& word = {}) {
  return {Action::Kind::kOrder, {name, command, word}};
}

Action say_mode(Keyboard& keyboard, Mode mode) {
  keyboard.by_hand.reset();
  supervisor::OperatorWord word;
  word.command = Command::kMode;
  word.mode = mode;
  return say(scarab_OPERATOR_MODE, "mode " + std::string(supervisor::name(mode)), word);
}

Action say_strategy(Keyboard& keyboard, const std::string& strategy) {
  keyboard.by_hand.reset();
  keyboard.page = Page::kMain;
  supervisor::OperatorWord word;
  word.command = Command::kStrategy;
  word.strategy = strategy;
  return say(scarab_OPERATOR_STRATEGY, "strategy " + strategy, word);
}

/// In whole hundredths, so that steps up and down lead back.
Action step_input(Keyboard& keyboard, const Inputs& live, double step) {
  Inputs inputs = keyboard.by_hand.value_or(live);
  double& input = inputs[keyboard.selected_input];
  input = std::clamp(std::round((input + step) * 100) / 100, -1.0, 1.0);
  keyboard.by_hand = inputs;
  supervisor::OperatorWord word;
  word.command = Command::kInputs;
  word.inputs = inputs;
  return say(scarab_OPERATOR_INPUTS, "inputs", word);
}

Action press_main(Keyboard& keyboard, Key key, const Inputs& live) {
  for (const auto& entry : kModeKeys) {
    if (is(key, entry.key)) return say_mode(keyboard, entry.mode);
  }
  for (const auto& entry : kMasterKeys) {
    if (is(key, entry.key)) return say(entry.command, entry.name);
  }
  for (const auto& entry : kPageKeys) {
    if (is(key, entry.key)) keyboard.page = entry.page;
  }
  if (key == Key::kUp) return step_input(keyboard, live, kInputStep);
  if (key == Key::kDown) return step_input(keyboard, live, -kInputStep);
  const int digit = static_cast<int>(key) - '1';
  if (digit >= 0 && digit < static_cast<int>(live.size())) {
    keyboard.selected_input = static_cast<std::size_t>(digit);
  }
  if (is(key, 'a')) {
    keyboard.by_hand.reset();
    return say(scarab_OPERATOR_AUTOMATIC, "automatic");
  }
  if (is(key, 't')) return {Action::Kind::kTrial, {}};
  if (is(key, 'q')) return {Action::Kind::kQuit, {}};
  return {};
}

Action press_menu(Keyboard& keyboard, Key key, const std::vector<std::string>& strategies) {
  if (key == Key::kDown && keyboard.menu_entry + 1 < strategies.size()) ++keyboard.menu_entry;
  if (key == Key::kUp && keyboard.menu_entry > 0) --keyboard.menu_entry;
  if (key == Key::kEnter && keyboard.menu_entry < strategies.size()) {
    return say_strategy(keyboard, strategies[keyboard.menu_entry]);
  }
  if (key == Key::kEscape || is(key, 'q') || is(key, 'm')) keyboard.page = Page::kMain;
  return {};
}

/// Anything but a clear yes is a no.
Action press_confirm(Keyboard& keyboard, Key key) {
  const Page asked = keyboard.page;
  keyboard.page = Page::kMain;
  if (!is(key, 'y')) return {};
  return asked == Page::kConfirmReset ? say(scarab_OPERATOR_RESET, "reset")
                                      : say(scarab_OPERATOR_STOP, "stop");
}

}  // namespace

std::vector<KeyHelp> key_help() {
  std::vector<KeyHelp> help = {{"SPACE", "EMERGENCY STOP: the robot holds still until a reset"}};
  for (const auto& entry : kModeKeys) {
    help.push_back({{entry.key}, "mode " + std::string(supervisor::name(entry.mode))});
  }
  help.push_back({"a", "automatic: the strategy decides again, from its approach on"});
  help.push_back({"1 2 3 4", "choose the input I1..I4 for up and down"});
  help.push_back({"up down", "the chosen input by 0.1, by hand"});
  for (const auto& entry : kMasterKeys) help.push_back({{entry.key}, entry.does});
  for (const auto& entry : kPageKeys) help.push_back({{entry.key}, entry.does});
  help.push_back({"t", "start a trial, where none runs"});
  help.push_back({"q", "quit; the stack stays as it is"});
  return help;
}

Action press(Keyboard& keyboard, Key key, const Inputs& live,
             const std::vector<std::string>& strategies) {
  if (key == Key::kEmergency) {
    keyboard.page = Page::kMain;
    return say(scarab_OPERATOR_EMERGENCY_STOP, "emergency stop");
  }
  if (key == Key::kRedraw) return {Action::Kind::kRedraw, {}};
  switch (keyboard.page) {
    case Page::kMain:
      return press_main(keyboard, key, live);
    case Page::kStrategies:
      return press_menu(keyboard, key, strategies);
    case Page::kConfirmReset:
    case Page::kConfirmStop:
      return press_confirm(keyboard, key);
    case Page::kHelp:
      keyboard.page = Page::kMain;
      return {};
  }
  return {};
}

void follow(Keyboard& keyboard, const Inputs& live) {
  if (keyboard.by_hand && *keyboard.by_hand != live) keyboard.by_hand.reset();
}

}  // namespace scarab::drive
