#include "common/runtime/screen.hpp"

#include <unistd.h>

#include <iostream>

namespace scarab::runtime {
namespace {

constexpr std::chrono::milliseconds kTerminalPeriod{100};
constexpr std::chrono::milliseconds kFilePeriod{2000};
constexpr const char* kClearLine = "\r\033[K";

}  // namespace

Screen::Screen(bool quiet) : quiet_(quiet), terminal_(::isatty(STDOUT_FILENO) == 1) {}

Screen::~Screen() { clear(); }

void Screen::line(const std::string& text) {
  clear();
  std::cout << text << '\n' << std::flush;
}

void Screen::detail(const std::string& text) {
  if (!quiet_) line(text);
}

void Screen::progress(const std::string& text) {
  const auto now = std::chrono::steady_clock::now();
  if (quiet_ || text == last_ || now - last_time_ < (terminal_ ? kTerminalPeriod : kFilePeriod))
    return;
  last_time_ = now;
  last_ = text;
  if (terminal_) {
    std::cout << kClearLine << text << std::flush;
    shown_ = true;
  } else {
    std::cout << text << '\n' << std::flush;
  }
}

void Screen::clear() {
  if (shown_) std::cout << kClearLine << std::flush;
  shown_ = false;
}

}  // namespace scarab::runtime
