#include "tools/config/difference.hpp"

#include <algorithm>
#include <string_view>

#include "common/config/emit.hpp"
#include "common/config/key_path.hpp"

namespace scarab::config_tool {
namespace {

using config::Value;
using Kind = Value::Kind;

/// YAML on one line.
std::string in_flow(const Value* value) {
  if (value == nullptr) return "(none)";
  const bool is_map = value->kind == Kind::kMap;
  if (!is_map && value->kind != Kind::kList) {
    std::string text = config::emit(*value);
    text.pop_back();  // the end of the line
    return text;
  }
  std::string text = is_map ? "{" : "[";
  for (std::size_t i = 0; i < value->items.size(); ++i) {
    if (i > 0) text += ", ";
    if (is_map) text += value->keys[i].text + ": ";
    text += in_flow(&value->items[i]);
  }
  return text + (is_map ? "}" : "]");
}

const Value* find(const Value& map, std::string_view key) {
  for (std::size_t i = 0; i < map.keys.size(); ++i) {
    if (map.keys[i].text == key) return &map.items[i];
  }
  return nullptr;
}

void compare(const std::string& path, const Value* a, const Value* b,
             std::vector<std::string>& out) {
  if (a != nullptr && b != nullptr && a->kind == Kind::kMap && b->kind == Kind::kMap) {
    for (const config::Key& key : a->keys) {
      compare(config::join_key(path, key.text), find(*a, key.text), find(*b, key.text), out);
    }
    for (const config::Key& key : b->keys) {
      if (find(*a, key.text) == nullptr) {
        compare(config::join_key(path, key.text), nullptr, find(*b, key.text), out);
      }
    }
    return;
  }
  const std::string before = in_flow(a);
  const std::string after = in_flow(b);
  if (before != after) out.push_back(config::shown_path(path) + ": " + before + " -> " + after);
}

}  // namespace

std::vector<std::string> differences(const Value& a, const Value& b) {
  std::vector<std::string> result;
  compare("", &a, &b, result);
  return result;
}

}  // namespace scarab::config_tool
