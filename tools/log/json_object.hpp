#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/config/json.hpp"

namespace scarab::log {

/// A JSON object or list that is put together key by key.
class JsonObject {
 public:
  JsonObject& text(const std::string& key, const std::string& value) {
    return raw(key, config::in_json_quotes(value));
  }
  JsonObject& number(const std::string& key, std::uint64_t value) {
    return raw(key, std::to_string(value));
  }
  JsonObject& truth(const std::string& key, bool value) {
    return raw(key, value ? "true" : "false");
  }
  /// A value that is JSON already.
  JsonObject& raw(const std::string& key, const std::string& json) {
    members_ += (members_.empty() ? "" : ", ") + config::in_json_quotes(key) + ": " + json;
    return *this;
  }
  std::string str() const { return "{" + members_ + "}"; }

 private:
  std::string members_;
};

/// A list of values that are JSON already, each on a line with this margin.
inline std::string json_list(const std::vector<std::string>& values, const std::string& margin) {
  std::string text;
  for (const std::string& value : values) text += (text.empty() ? "\n" : ",\n") + margin + value;
  return text.empty() ? "[]" : "[" + text + "]";
}

}  // namespace scarab::log
