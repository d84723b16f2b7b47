#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace scarab::config {

/// What follows `file:line:col: ` in an error of that form, with line and column above 0, on one
/// line and with a key and a reason; nothing if the error has another form. (std::regex trips GCC
/// 12's sanitizer warnings.)
inline std::optional<std::string> key_and_reason(const std::string& error,
                                                 const std::string& file) {
  if (error.rfind(file + ":", 0) != 0 || error.find('\n') != std::string::npos) return std::nullopt;
  std::size_t at = file.size() + 1;
  for (const char* end : {":", ": "}) {
    const std::size_t stop = error.find_first_not_of("0123456789", at);
    if (stop == std::string::npos || stop == at || error[at] == '0') return std::nullopt;
    if (error.compare(stop, std::string(end).size(), end) != 0) return std::nullopt;
    at = stop + std::string(end).size();
  }
  const std::string rest = error.substr(at);
  const std::size_t colon = rest.find(": ");
  const bool complete = colon != std::string::npos && colon > 0 && colon + 2 < rest.size();
  return complete ? std::optional(rest) : std::nullopt;
}

}  // namespace scarab::config
