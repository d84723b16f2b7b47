#include "tools/drive/terminal.hpp"

#include <curses.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace scarab::drive {
namespace {

enum Pair : short { kNoPair, kGreen, kYellow, kWhiteOnRed };

void set_up_colours() {
  if (!has_colors()) return;
  start_color();
  use_default_colors();
  init_pair(kGreen, COLOR_GREEN, -1);
  init_pair(kYellow, COLOR_YELLOW, -1);
  init_pair(kWhiteOnRed, COLOR_WHITE, COLOR_RED);
}

/// Without colours the attributes alone must tell.
attr_t attributes(Style style) {
  const auto pair = [](Pair number) {
    return has_colors() ? static_cast<attr_t>(COLOR_PAIR(number)) : static_cast<attr_t>(A_NORMAL);
  };
  switch (style) {
    case Style::kPlain:
      return A_NORMAL;
    case Style::kDim:
      return A_DIM;
    case Style::kBold:
      return A_BOLD;
    case Style::kGood:
      return pair(kGreen);
    case Style::kWarning:
      return pair(kYellow) | A_BOLD;
    case Style::kAlarm:
      return has_colors() ? pair(kWhiteOnRed) | A_BOLD : A_REVERSE | A_BOLD;
    case Style::kSelected:
      return A_REVERSE;
  }
  return A_NORMAL;
}

}  // namespace

bool has_terminal() { return ::isatty(STDIN_FILENO) != 0 && ::isatty(STDOUT_FILENO) != 0; }

std::optional<Size> terminal_size() {
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0) return std::nullopt;
  return Size{size.ws_col, size.ws_row};
}

struct Terminal::Screen {
  SCREEN* handle = nullptr;
};

Terminal::Terminal() : screen_(std::make_unique<Screen>()) {
  // initscr() would end the program for an unknown terminal.
  screen_->handle = ::newterm(nullptr, stdout, stdin);
  if (screen_->handle == nullptr) {
    const char* name = std::getenv("TERM");  // NOLINT(concurrency-mt-unsafe): nobody sets it
    throw UnknownTerminal("the terminal type '" + std::string(name != nullptr ? name : "") +
                          "' (TERM) is not known here; try TERM=xterm");
  }
  set_escdelay(25);  // ms; Escape alone is a key
  cbreak();
  noecho();
  nonl();
  keypad(stdscr, TRUE);
  nodelay(stdscr, TRUE);
  curs_set(0);
  set_up_colours();
}

Terminal::~Terminal() {
  ::endwin();
  ::delscreen(screen_->handle);
}

Size Terminal::size() const {
  return {static_cast<std::size_t>(std::max(COLS, 0)),
          static_cast<std::size_t>(std::max(LINES, 0))};
}

void Terminal::show(const std::vector<Line>& lines) {
  erase();
  for (std::size_t row = 0; row < lines.size(); ++row) {
    move(static_cast<int>(row), 0);
    for (const Span& span : lines[row]) {
      attrset(static_cast<int>(attributes(span.style)));
      addstr(span.text.c_str());
    }
  }
  attrset(A_NORMAL);
  refresh();
}

void Terminal::redraw() { clearok(stdscr, TRUE); }

std::optional<Key> Terminal::key() {
  const int code = getch();
  switch (code) {
    case ERR:
      return std::nullopt;
    case KEY_UP:
      return Key::kUp;
    case KEY_DOWN:
      return Key::kDown;
    case KEY_ENTER:
    case '\r':
      return Key::kEnter;
    case KEY_RESIZE:
      return Key::kRedraw;
    default:
      return static_cast<Key>(code < 0x100 ? code : 0);
  }
}

}  // namespace scarab::drive
