#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

#include "tools/drive/view.hpp"

namespace scarab::drive {

/// Stdin and stdout are a terminal, both.
bool has_terminal();

/// The terminal's size; nothing without a terminal.
std::optional<Size> terminal_size();

/// TERM names a kind of terminal that nobody has described here.
class UnknownTerminal : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The whole terminal, taken over with ncurses; the destructor gives it back as it was, whatever
/// ends the program but SIGKILL. Only one at a time. Text is in the characters of the locale
/// (LC_CTYPE).
class Terminal {
 public:
  /// Throws UnknownTerminal for a terminal that ncurses does not know (TERM).
  Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  ~Terminal();

  [[nodiscard]] Size size() const;
  void show(const std::vector<Line>& lines);
  /// Paints every character anew with the next show().
  void redraw();
  /// The next key that waits, without waiting for one.
  std::optional<Key> key();

 private:
  struct Screen;
  std::unique_ptr<Screen> screen_;
};

}  // namespace scarab::drive
