#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace scarab::config {

/// Where something stands: line and column from 1, in one of the files of a Document.
struct Position {
  int line = 1;
  int column = 1;
  std::size_t file = 0;  ///< index into Document::files
};

/// Bad configuration. what() is one line, exactly `file:line:col: key: reason`, where key is the
/// dotted path of the offending key such as `legs.front.coxa.length_m`, `(top level)`, `(syntax)`
/// or `(file)`.
class Error : public std::runtime_error {
 public:
  Error(std::string_view file, Position position, std::string_view key, std::string_view reason);
};

/// Text from a file as it is shown in an error: in single quotes, on one line, shortened if long.
[[nodiscard]] std::string in_quotes(std::string_view text);

}  // namespace scarab::config
