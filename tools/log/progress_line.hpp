#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace scarab::log {

/// How far long work is, on a line of its own at the terminal (stderr) that goes when it is done.
/// Says nothing where stderr is no terminal, and nothing of work that is done at once.
class ProgressLine {
 public:
  /// `what`: such as `reading trial.mcap`.
  explicit ProgressLine(std::string what);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void update(std::uint64_t done, std::uint64_t total);
  /// Another text in its place, such as `tick 57 of 176`.
  void say(const std::string& text);

 private:
  bool is_due();

  std::string what_;
  bool terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace scarab::log
