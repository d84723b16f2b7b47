#include "common/config/cursor.hpp"

#include <utility>

#include "common/config/key_path.hpp"
#include "common/config/scalar.hpp"
#include "common/config/suggestion.hpp"

namespace scarab::config {
namespace {

using Kind = Value::Kind;

std::string found(const Value& value) {
  switch (value.kind) {
    case Kind::kNothing:
      return "nothing";
    case Kind::kList:
      return "a list";
    case Kind::kMap:
      return "a map";
    case Kind::kScalar:
      break;
  }
  return value.plain ? in_quotes(value.text) : "the text " + in_quotes(value.text);
}

std::string list_of(const std::vector<std::string_view>& names) {
  std::string result;
  for (const std::string_view name : names) {
    if (!result.empty()) result += ", ";
    result += name;
  }
  return result;
}

}  // namespace

Cursor::Cursor(const Document& document) : Cursor(document, document.root, "") {}

Cursor::Cursor(const Document& document, const Value& value, std::string path)
    : document_(&document), value_(&value), path_(std::move(path)) {}

void Cursor::fail(std::string_view reason) const {
  fail_at(value_->position, shown_path(path_), reason);
}

void Cursor::fail_at(std::string_view key, std::string_view reason) const {
  fail_at(nearest(key).value_->position, join_key(path_, key), reason);
}

void Cursor::fail_expecting(std::string_view expected) const {
  fail("expected " + std::string(expected) + ", found " + found(*value_));
}

void Cursor::fail_at(Position position, std::string_view path, std::string_view reason) const {
  const std::vector<std::string>& files = document_->files;
  const bool in_base = position.file != 0;
  throw Error(files[position.file], position, path,
              std::string(reason) + (in_base ? " (extended by '" + files[0] + "')" : ""));
}

std::optional<Cursor> Cursor::find(std::string_view key) const {
  if (value_->kind != Kind::kMap) fail_expecting("a map");
  for (std::size_t i = 0; i < value_->keys.size(); ++i) {
    if (value_->keys[i].text == key) {
      return Cursor(*document_, value_->items[i], join_key(path_, key));
    }
  }
  return std::nullopt;
}

Cursor Cursor::at(std::string_view key) const {
  if (const auto value = find(key)) return *value;
  fail_at(key, "missing key");
}

Cursor Cursor::nearest(std::string_view path) const {
  Cursor result = *this;
  while (!path.empty() && result.value_->kind == Kind::kMap) {
    const std::size_t dot = path.find('.');
    const auto next = result.find(path.substr(0, dot));
    if (!next) break;
    result = *next;
    path = dot == std::string_view::npos ? std::string_view{} : path.substr(dot + 1);
  }
  return result;
}

std::vector<Cursor> Cursor::elements(std::optional<std::size_t> size) const {
  const std::string count = size ? " of " + std::to_string(*size) : "";
  if (value_->kind != Kind::kList) fail_expecting("a list" + count);
  if (size && value_->items.size() != *size) {
    fail("expected a list" + count + ", found " + std::to_string(value_->items.size()) +
         (value_->items.size() == 1 ? " element" : " elements"));
  }
  std::vector<Cursor> result;
  for (std::size_t i = 0; i < value_->items.size(); ++i) {
    result.push_back(Cursor(*document_, value_->items[i], join_index(path_, i)));
  }
  return result;
}

std::vector<std::pair<std::string, Cursor>> Cursor::entries() const {
  if (value_->kind != Kind::kMap) fail_expecting("a map");
  std::vector<std::pair<std::string, Cursor>> result;
  for (std::size_t i = 0; i < value_->keys.size(); ++i) {
    const std::string& key = value_->keys[i].text;
    result.emplace_back(key, Cursor(*document_, value_->items[i], join_key(path_, key)));
  }
  return result;
}

void Cursor::expect_map_of(const std::vector<std::string_view>& known) const {
  if (value_->kind != Kind::kMap) fail_expecting("a map with the keys " + list_of(known));
  for (const Key& key : value_->keys) {
    bool is_known = false;
    for (const std::string_view name : known) is_known = is_known || name == key.text;
    if (is_known) continue;
    const auto near = closest(key.text, known);
    fail_at(key.position, join_key(path_, key.text),
            near ? "unknown key; did you mean '" + std::string(*near) + "'?"
                 : "unknown key; known here: " + list_of(known));
  }
}

const std::string& Cursor::plain_scalar(std::string_view expected) const {
  if (value_->kind != Kind::kScalar || !value_->plain) fail_expecting(expected);
  return value_->text;
}

double Cursor::number(const Range& range) const {
  const std::string& text = plain_scalar("a number");
  const Parsed<double> parsed = parse_number(text);
  if (!parsed.value) fail(parsed.reason);
  if (!range.contains(*parsed.value)) fail(text + " is not " + describe(range));
  return *parsed.value;
}

long long Cursor::signed_integer(long long min, long long max, const Range& range) const {
  const std::string& text = plain_scalar("a whole number");
  const Parsed<long long> parsed = parse_signed(text);
  if (!parsed.value) fail(parsed.reason);
  if (*parsed.value < min || *parsed.value > max) {
    fail(text + " is not in [" + std::to_string(min) + ", " + std::to_string(max) + "]");
  }
  if (!range.contains(static_cast<double>(*parsed.value))) {
    fail(text + " is not " + describe(range));
  }
  return *parsed.value;
}

unsigned long long Cursor::unsigned_integer(unsigned long long max, const Range& range) const {
  const std::string& text = plain_scalar("a whole number");
  const Parsed<unsigned long long> parsed = parse_unsigned(text);
  if (!parsed.value) fail(parsed.reason);
  if (*parsed.value > max) fail(text + " is not in [0, " + std::to_string(max) + "]");
  if (!range.contains(static_cast<double>(*parsed.value))) {
    fail(text + " is not " + describe(range));
  }
  return *parsed.value;
}

bool Cursor::truth() const {
  const std::string& text = plain_scalar("true or false");
  if (text != "true" && text != "false") fail_expecting("true or false");
  return text == "true";
}

std::string Cursor::text() const {
  if (value_->kind != Kind::kScalar) fail_expecting("text");
  return value_->text;
}

std::size_t Cursor::one_of(const std::vector<std::string_view>& names) const {
  if (value_->kind != Kind::kScalar) fail_expecting("one of " + list_of(names));
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == value_->text) return i;
  }
  const auto near = closest(value_->text, names);
  fail("expected one of " + list_of(names) + ", found " + in_quotes(value_->text) +
       (near ? "; did you mean '" + std::string(*near) + "'?" : ""));
}

bool Cursor::says_absent() const {
  return value_->kind == Kind::kScalar && value_->plain && value_->text == "absent";
}

}  // namespace scarab::config
