#pragma once

#include <termios.h>

#include <optional>

#include "common/runtime/screen.hpp"
#include "services/robot_bridge/calibrate/console.hpp"

namespace scarab::bridge::calibrate {

/// Stdin and stdout. A terminal gives each key at once and without echo until the destructor puts
/// it back; a pipe gives its characters as keys. One at a time; made before any thread: it takes
/// SIGINT and SIGTERM for the whole process.
class TerminalConsole : public Console {
 public:
  TerminalConsole();
  ~TerminalConsole() override;

  Key key(std::chrono::milliseconds longest) override;
  void line(const std::string& text) override { screen_.line(text); }
  void live(const std::string& text) override { screen_.progress(text); }

 private:
  runtime::Screen screen_{false};
  std::optional<termios> before_;  ///< the terminal's settings, if stdin is one
  int signals_ = -1;               ///< signalfd
};

}  // namespace scarab::bridge::calibrate
