#include "tools/search/value_path.hpp"

#include <charconv>
#include <optional>
#include <stdexcept>

#include "common/config/scalar.hpp"

namespace scarab::search {
namespace {

using config::Value;

std::optional<std::size_t> index_of(const Value& value, std::string_view step) {
  if (value.kind == Value::Kind::kList) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(step.data(), step.data() + step.size(), index);
    const bool whole = error == std::errc{} && end == step.data() + step.size();
    if (whole && index < value.items.size()) return index;
  }
  if (value.kind == Value::Kind::kMap) {
    for (std::size_t i = 0; i < value.keys.size(); ++i) {
      if (value.keys[i].text == step) return i;
    }
  }
  return std::nullopt;
}

}  // namespace

const Value* find_value(const Value& root, std::string_view path) {
  const Value* at = &root;
  while (!path.empty()) {
    const std::size_t dot = path.find('.');
    const auto index = index_of(*at, path.substr(0, dot));
    if (!index) return nullptr;
    at = &at->items[*index];
    path = dot == std::string_view::npos ? std::string_view{} : path.substr(dot + 1);
  }
  return at;
}

Value* find_value(Value& root, std::string_view path) {
  // The one place that takes the const away again: the tree was given as one that may be changed.
  return const_cast<Value*>(find_value(static_cast<const Value&>(root), path));
}

double number_at(const Value& root, std::string_view path) {
  const Value* value = find_value(root, path);
  if (value != nullptr && value->kind == Value::Kind::kScalar && value->plain) {
    if (const auto parsed = config::parse_number(value->text); parsed.value) return *parsed.value;
  }
  throw std::invalid_argument("no number at " + std::string(path));
}

}  // namespace scarab::search
