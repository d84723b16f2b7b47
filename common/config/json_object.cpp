#include "common/config/json_object.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace scarab::config {

JsonObject& JsonObject::number(const std::string& key, double value) {
  std::array<char, 32> text;
  char* end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return raw(key, std::isfinite(value) ? std::string(text.data(), end) : "null");
}

std::string json_list(const std::vector<std::string>& values) {
  std::string out;
  for (const std::string& value : values) out += (out.empty() ? "" : ", ") + value;
  return "[" + out + "]";
}

std::string json_lines(const std::vector<std::string>& values, const std::string& margin) {
  std::string out;
  for (const std::string& value : values) out += (out.empty() ? "\n" : ",\n") + margin + value;
  return "[" + out + "]";
}

}  // namespace scarab::config
