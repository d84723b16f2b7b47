#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/topics.hpp"
#include "services/supervisor/core/operator_word.hpp"

namespace scarab::drive {

/// A key as the terminal gives it; the others are the characters they make.
enum class Key : int {
  kRedraw = 12,  ///< Ctrl-L
  kEnter = '\n',
  kEscape = 27,
  kEmergency = ' ',
  kUp = 0x100,
  kDown,
};

/// What the screen shows beside the live state, and so what keys mean.
enum class Page { kMain, kStrategies, kConfirmReset, kConfirmStop, kHelp };

using Inputs = std::array<double, 4>;

/// What the keyboard remembers between two keys.
struct Keyboard {
  Page page = Page::kMain;
  std::size_t selected_input = 0;  ///< I1..I4 as 0..3
  std::optional<Inputs> by_hand;   ///< the inputs last given here, while they count
  std::size_t menu_entry = 0;      ///< of the strategies
};

/// Something to say on scarab/operator.
struct Order {
  std::string name;  ///< for the person, such as "mode forward"
  scarab_OperatorCommand command = scarab_OPERATOR_PAUSE;
  supervisor::OperatorWord word;  ///< for the supervisor's commands
};

struct Action {
  enum class Kind { kNothing, kOrder, kTrial, kQuit, kRedraw };

  Kind kind = Kind::kNothing;
  Order order;  ///< of kOrder
};

/// One line of the help: a key and what it does.
struct KeyHelp {
  std::string key;
  std::string does;
};

/// All keys of the main page, for the help.
std::vector<KeyHelp> key_help();

/// What a key does now. The emergency stop does the same on every page. `live`: the inputs that
/// hold, from which steps by hand start; `strategies`: of the menu.
Action press(Keyboard& keyboard, Key key, const Inputs& live,
             const std::vector<std::string>& strategies);

/// Forgets the inputs given here once others hold, so that the next step starts from those.
void follow(Keyboard& keyboard, const Inputs& live);

}  // namespace scarab::drive
