#pragma once

#include <functional>
#include <optional>
#include <string>

namespace scarab::experiment {

/// Lines from a file descriptor, as they come.
class LineInput {
 public:
  /// `interrupted` is asked while it waits; the descriptor stays the caller's.
  LineInput(int descriptor, std::function<bool()> interrupted)
      : descriptor_(descriptor), interrupted_(std::move(interrupted)) {}

  /// Waits for the next line, without its newline; none at the end. A last line may lack the
  /// newline. Throws Interrupted; std::system_error where reading fails.
  [[nodiscard]] std::optional<std::string> next();

 private:
  void fill();

  int descriptor_;
  std::function<bool()> interrupted_;
  std::string text_;  // read, but not asked for yet
  bool ended_ = false;
};

}  // namespace scarab::experiment
