#pragma once

#include <sys/types.h>
#include <termios.h>

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/eventually.hpp"

namespace scarab::test {

/// A program at a terminal of its own, with the test in the place of the person. The program never
/// outlives the object.
class PseudoTerminal {
 public:
  struct Start {
    std::vector<std::string> command;
    unsigned short columns = 100;
    unsigned short rows = 30;
    std::string type = "xterm";  ///< TERM
  };

  /// Throws std::system_error if there is no pseudo-terminal or no program.
  explicit PseudoTerminal(const Start& start);
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;
  ~PseudoTerminal();

  void type(const std::string& keys);
  void resize(unsigned short columns, unsigned short rows);
  void signal(int number);

  /// All bytes the program has written so far.
  const std::string& output();
  /// What stands in the output from byte `from` on, without escape sequences, blanks and line ends:
  /// how a screen is painted is the program's business.
  std::string letters(std::size_t from = 0);
  /// Has it paint the whole screen until that shows `text` (blanks do not count).
  bool shows(const std::string& text, std::chrono::milliseconds limit = kPatience);

  /// Its exit code once it has ended, 128 + n if signal n ended it; nothing after `limit`.
  std::optional<int> wait(std::chrono::milliseconds limit = kPatience);

  /// The terminal's modes are those from before the start, the alternate screen is left and the
  /// cursor shown.
  bool is_as_it_was();

 private:
  void drain();

  int person_ = -1;    // our side
  int terminal_ = -1;  // the program's side, kept open to look at its modes
  termios before_{};
  pid_t pid_ = -1;
  std::optional<int> exit_code_;
  std::string output_;
};

}  // namespace scarab::test
