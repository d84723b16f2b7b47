#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace scarab::topic {

// Beside those of every program (common/runtime/program.hpp).
inline constexpr int kExitTimeout = 3;  ///< the topic is there, but not what was waited for
inline constexpr int kExitNoTopic = 4;
inline constexpr int kExitNoType = 5;

/// Ends the program with a line on stderr and an exit code.
class Failure : public std::runtime_error {
 public:
  Failure(int exit_code, const std::string& message)
      : std::runtime_error(message), exit_code_(exit_code) {}
  int exit_code() const { return exit_code_; }

 private:
  int exit_code_;
};

/// Ctrl-C before the work was done.
struct Interrupted {};

/// `; did you mean tick?` if one of the names is near enough, else nothing.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& names);

/// Calls `read`, which makes something of words from the command line. What bus::Error it throws is
/// bad usage: `context: reason`, with the name that may have been meant.
void refuse_bad_usage(const std::string& context, const std::function<void()>& read);

}  // namespace scarab::topic
