#pragma once

#include <chrono>
#include <string>

namespace scarab::runtime {

/// The terminal: lines that stay, and one progress line that is written over. Where stdout is no
/// terminal the progress line comes out as a line of its own now and then.
class Screen {
 public:
  explicit Screen(bool quiet);
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  void line(const std::string& text);
  /// A line that quiet leaves out.
  void detail(const std::string& text);
  void progress(const std::string& text);

 private:
  void clear();

  bool quiet_;
  bool terminal_;
  bool shown_ = false;
  std::string last_;
  std::chrono::steady_clock::time_point last_time_{};
};

}  // namespace scarab::runtime
