#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/config/json.hpp"

namespace scarab::config {

/// A JSON object that is put together key by key, on one line.
class JsonObject {
 public:
  JsonObject& text(const std::string& key, const std::string& value) {
    return raw(key, in_json_quotes(value));
  }
  JsonObject& number(const std::string& key, std::uint64_t value) {
    return raw(key, std::to_string(value));
  }
  JsonObject& number(const std::string& key, std::uint32_t value) {
    return number(key, std::uint64_t{value});
  }
  /// Null where it is not finite, for which JSON has no number.
  JsonObject& number(const std::string& key, double value);
  JsonObject& truth(const std::string& key, bool value) {
    return raw(key, value ? "true" : "false");
  }
  /// A value that is JSON already.
  JsonObject& raw(const std::string& key, const std::string& json) {
    members_ += (members_.empty() ? "" : ", ") + in_json_quotes(key) + ": " + json;
    return *this;
  }
  std::string str() const { return "{" + members_ + "}"; }

 private:
  std::string members_;
};

/// A list of values that are JSON already, on one line.
std::string json_list(const std::vector<std::string>& values);

/// The same with each value on a line of its own, which begins with `margin`.
std::string json_lines(const std::vector<std::string>& values, const std::string& margin);

}  // namespace scarab::config
