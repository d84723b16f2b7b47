#include "tools/topic/value_text.hpp"

#include <utility>

#include "common/config/document.hpp"

namespace scarab::topic {
namespace {

sample::WrittenValue written(const config::Value& value) {
  using From = config::Value::Kind;
  using To = sample::WrittenValue::Kind;
  sample::WrittenValue out;
  out.kind = value.kind == From::kScalar ? To::kText
             : value.kind == From::kList ? To::kList
             : value.kind == From::kMap  ? To::kMap
                                         : To::kNothing;
  out.text = value.text;
  out.quoted = !value.plain;
  for (const config::Key& key : value.keys) out.keys.push_back(key.text);
  for (const config::Value& item : value.items) out.items.push_back(written(item));
  return out;
}

bool is_empty(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first == std::string_view::npos || line[first] == '#';
}

bool ends_document(std::string_view line) {
  return line.substr(0, 3) == "---" || line.substr(0, 3) == "...";
}

}  // namespace

sample::WrittenValue read_value(const std::string& source, const std::string& text) {
  return written(config::parse_text(source, text).root);
}

std::optional<std::string> DocumentSplitter::add(std::string_view line) {
  if (!is_json_ && ends_document(line)) return complete();
  if (document_.empty()) {
    if (is_empty(line)) return std::nullopt;
    is_json_ = line.front() == '{' || line.front() == '[';
  }
  document_ += line;
  document_ += '\n';
  if (!is_json_) return std::nullopt;
  follow_brackets(line);
  return open_ <= 0 ? complete() : std::nullopt;
}

std::optional<std::string> DocumentSplitter::finish() { return complete(); }

std::optional<std::string> DocumentSplitter::complete() {
  is_json_ = false;
  open_ = 0;
  in_text_ = escaped_ = false;
  if (document_.empty()) return std::nullopt;
  return std::exchange(document_, "");
}

void DocumentSplitter::follow_brackets(std::string_view line) {
  for (const char c : line) {
    if (escaped_) {
      escaped_ = false;
    } else if (in_text_) {
      escaped_ = c == '\\';
      if (c == '"') in_text_ = false;
    } else if (c == '"') {
      in_text_ = true;
    } else if (c == '{' || c == '[') {
      ++open_;
    } else if (c == '}' || c == ']') {
      --open_;
    }
  }
}

}  // namespace scarab::topic
