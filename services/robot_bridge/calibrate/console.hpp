#pragma once

#include <chrono>
#include <stdexcept>
#include <string>

namespace scarab::bridge::calibrate {

/// What a person at the keyboard says. Every other key is kNone.
enum class Key { kNone, kEnter, kPlus, kMinus, kSkip, kKeep, kQuit };

/// SIGINT or SIGTERM came.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

/// Where the tool talks with a person.
class Console {
 public:
  Console() = default;
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;
  virtual ~Console() = default;

  /// The next key; kNone if none comes within `longest`. The end of the input is kQuit. Throws
  /// Interrupted.
  virtual Key key(std::chrono::milliseconds longest) = 0;
  /// A line that stays.
  virtual void line(const std::string& text) = 0;
  /// The line that is written over.
  virtual void live(const std::string& text) = 0;
};

}  // namespace scarab::bridge::calibrate
