#include "tools/topic/json_object.hpp"

#include <fmt/format.h>

#include <cmath>

namespace scarab::topic {

JsonObject& JsonObject::number(const std::string& key, double value) {
  return raw(key, std::isfinite(value) ? fmt::format("{}", value) : "null");
}

std::string json_list(const std::vector<std::string>& values) {
  std::string out;
  for (const std::string& value : values) out += (out.empty() ? "" : ", ") + value;
  return "[" + out + "]";
}

}  // namespace scarab::topic
