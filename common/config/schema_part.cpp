#include "common/config/schema_part.hpp"

#include <limits>
#include <utility>

#include "common/config/json.hpp"
#include "common/config/scalar.hpp"
#include "common/config/unit.hpp"

namespace scarab::config {
namespace {

using Kind = Value::Kind;

Value bare(std::string text) {
  Value value;
  value.kind = Kind::kScalar;
  value.text = std::move(text);
  return value;
}

Value quoted(std::string_view text) {
  Value value = bare(std::string(text));
  value.plain = false;
  return value;
}

Value list_of(std::vector<Value> items) {
  Value value;
  value.kind = Kind::kList;
  value.items = std::move(items);
  return value;
}

Value empty_map() {
  Value value;
  value.kind = Kind::kMap;
  return value;
}

void add(Value& map, std::string_view key, Value value) {
  map.keys.push_back({std::string(key), {}});
  map.items.push_back(std::move(value));
}

Value map_of(std::string_view key, Value value) {
  Value map = empty_map();
  add(map, key, std::move(value));
  return map;
}

Value of_type(std::string_view type) { return map_of("type", quoted(type)); }

void add_limits(Value& shape, const Range& range) {
  if (range.min > kAny.min) {
    add(shape, range.above_min ? "exclusiveMinimum" : "minimum", bare(format_number(range.min)));
  }
  if (range.max < kAny.max) add(shape, "maximum", bare(format_number(range.max)));
}

Range limits_of(bool is_signed, int bits) {
  if (bits > 32) return is_signed ? kAny : kNonNegative;  // beyond what a double holds exactly
  const double count = static_cast<double>(1ULL << (is_signed ? bits - 1 : bits));
  return {is_signed ? -count : 0.0, count - 1};
}

}  // namespace

SchemaPart schema_of_text() { return {of_type("string"), {}}; }

SchemaPart schema_of_truth() { return {of_type("boolean"), {}}; }

SchemaPart schema_of_number(const Range& range) {
  SchemaPart part{of_type("number"), {}};
  add_limits(part.shape, range);
  return part;
}

SchemaPart schema_of_integer(bool is_signed, int bits, const Range& range) {
  SchemaPart part{of_type("integer"), {}};
  Range both = limits_of(is_signed, bits);
  if (range.min >= both.min) {
    both.min = range.min;
    both.above_min = range.above_min;
  }
  if (range.max < both.max) both.max = range.max;
  add_limits(part.shape, both);
  return part;
}

SchemaPart schema_of_one_of(const std::vector<std::string_view>& names) {
  std::vector<Value> values;
  for (const std::string_view name : names) values.push_back(quoted(name));
  return {map_of("enum", list_of(std::move(values))), {}};
}

SchemaPart schema_of_list(SchemaPart element, std::optional<std::size_t> size) {
  SchemaPart part{of_type("array"), {}};
  const bool whole = element.needs.kind == Kind::kNothing;
  add(part.shape, "items",
      whole ? std::move(element.shape)
            : map_of("allOf", list_of({std::move(element.shape), std::move(element.needs)})));
  if (size) {
    add(part.shape, "minItems", bare(std::to_string(*size)));
    add(part.shape, "maxItems", bare(std::to_string(*size)));
  }
  return part;
}

SchemaPart schema_of_map(SchemaPart value) {
  SchemaPart part{of_type("object"), {}};
  add(part.shape, "additionalProperties", std::move(value.shape));
  if (value.needs.kind != Kind::kNothing) {
    part.needs = map_of("additionalProperties", std::move(value.needs));
  }
  return part;
}

SchemaPart schema_or_absent(SchemaPart value) {
  // What is needed of a map says nothing of a word: `needs` can stay as it is.
  Value either = list_of({map_of("const", quoted("absent")), std::move(value.shape)});
  return {map_of("anyOf", std::move(either)), std::move(value.needs)};
}

SchemaPart schema_of_struct(std::vector<SchemaKey> keys) {
  Value properties = empty_map();
  Value required = list_of({});
  Value needed_below = empty_map();
  for (SchemaKey& key : keys) {
    if (key.fallback) {
      add(key.value.shape, "default", std::move(*key.fallback));
    } else {
      required.items.push_back(quoted(key.name));
    }
    add(properties, key.name, std::move(key.value.shape));
    if (key.value.needs.kind != Kind::kNothing) {
      add(needed_below, key.name, std::move(key.value.needs));
    }
  }
  SchemaPart part{of_type("object"), empty_map()};
  add(part.shape, "additionalProperties", bare("false"));
  add(part.shape, "properties", std::move(properties));
  if (!required.items.empty()) add(part.needs, "required", std::move(required));
  if (!needed_below.items.empty()) add(part.needs, "properties", std::move(needed_below));
  if (part.needs.items.empty()) part.needs = Value{};
  return part;
}

void describe_value(SchemaPart& part, std::string_view key, const Range& range) {
  std::string text{unit_of(key)};
  if (range.min > kAny.min || range.max < kAny.max) {
    text += (text.empty() ? "" : ", ") + describe(range);
  }
  if (!text.empty()) add(part.shape, "description", quoted(text));
}

std::string schema_text(SchemaPart root, std::string_view title) {
  Value extends = of_type("string");
  add(extends, "description",
      quoted("the file that gives the keys not given here; its path is relative to this file"));
  Value document = map_of("$schema", quoted("http://json-schema.org/draft-07/schema#"));
  add(document, "$comment", quoted("Written by scarab-config schema; do not edit."));
  add(document, "title", quoted(title));
  for (std::size_t i = 0; i < root.shape.keys.size(); ++i) {
    Value& item = root.shape.items[i];
    const std::string& key = root.shape.keys[i].text;
    if (key == "properties") {
      item.keys.insert(item.keys.begin(), {"extends", {}});
      item.items.insert(item.items.begin(), extends);
    }
    add(document, key, std::move(item));
  }
  if (root.needs.kind != Kind::kNothing) {
    add(document, "if", map_of("required", list_of({quoted("extends")})));
    add(document, "else", std::move(root.needs));
  }
  return emit_json(document);
}

}  // namespace scarab::config
