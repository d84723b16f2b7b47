#include "common/config/error.hpp"

namespace scarab::config {
namespace {

constexpr std::size_t kShown = 60;  // characters

std::string one_line(std::string_view text) {
  std::string result;
  for (const char character : text) {
    const auto code = static_cast<unsigned char>(character);
    result += code < 0x20 || code == 0x7f ? '?' : character;
  }
  return result;
}

std::string compose(std::string_view file, Position position, std::string_view key,
                    std::string_view reason) {
  return one_line(file) + ":" + std::to_string(position.line) + ":" +
         std::to_string(position.column) + ": " + one_line(key) + ": " + one_line(reason);
}

}  // namespace

Error::Error(std::string_view file, Position position, std::string_view key,
             std::string_view reason)
    : std::runtime_error(compose(file, position, key, reason)) {}

std::string in_quotes(std::string_view text) {
  if (text.size() <= kShown) return "'" + one_line(text) + "'";
  return "'" + one_line(text.substr(0, kShown)) + "...'";
}

}  // namespace scarab::config
