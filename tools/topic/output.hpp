#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace scarab::topic {

/// Standard output, written in large pieces. Never blocks beyond Ctrl-C, and tells when its reader
/// has gone (`| head`); SIGPIPE has to be ignored.
class Output {
 public:
  /// `interrupted` is asked while whoever reads standard output is slow.
  explicit Output(std::function<bool()> interrupted);

  /// Both throw std::system_error where the output cannot be written for another reason than that
  /// nobody reads it.
  void write(std::string_view text);
  void flush();
  /// Nobody reads any more, or Ctrl-C came while nobody did: what is written from now on is lost.
  bool closed();

  /// Characters in a line of the terminal, or what COLUMNS says; 0: no terminal, lines may be as
  /// long as they are.
  static std::size_t width();
  static bool is_terminal();

 private:
  bool wait_until_writable();

  std::function<bool()> interrupted_;
  std::string pending_;
  bool closed_ = false;
};

}  // namespace scarab::topic
