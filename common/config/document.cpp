#include "common/config/document.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <cerrno>
#include <fstream>
#include <optional>
#include <sstream>
#include <system_error>
#include <utility>

#include "common/config/key_path.hpp"

namespace scarab::config {
namespace {

Position position_of(const YAML::Mark& mark) { return {mark.line + 1, mark.column + 1}; }

/// Builds a Value from the parser's events. The event level is the only one of yaml-cpp on which a
/// duplicate key can be seen: its nodes keep the first and drop the rest in silence.
class ValueBuilder : public YAML::EventHandler {
 public:
  explicit ValueBuilder(std::string_view file) : file_(file) {}

  [[nodiscard]] Value take_root() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark& /*mark*/) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    refuse_extras(mark, "", anchor);
    if (expects_key()) fail(mark, "a key must be text");
    Value value;
    value.position =
        open_.empty() || !open_.back().key ? position_of(mark) : open_.back().key->position;
    add(std::move(value));
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t /*anchor*/) override {
    fail(mark, "aliases are not supported; write the value out");
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& text) override {
    refuse_extras(mark, tag, anchor);
    if (expects_key()) return take_key(Key{text, position_of(mark)});
    Value value;
    value.kind = Value::Kind::kScalar;
    value.position = position_of(mark);
    value.text = text;
    value.plain = tag != "!";
    add(std::move(value));
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value /*style*/) override {
    open(mark, tag, anchor, Value::Kind::kList);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value /*style*/) override {
    open(mark, tag, anchor, Value::Kind::kMap);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapEnd() override { close(); }

 private:
  /// A list or map whose end has not been seen.
  struct Open {
    Value value;
    std::optional<Key> key;  ///< of the value to come, in a map
  };

  [[nodiscard]] bool expects_key() const {
    return !open_.empty() && open_.back().value.kind == Value::Kind::kMap && !open_.back().key;
  }

  void open(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
            Value::Kind kind) {
    refuse_extras(mark, tag, anchor);
    if (expects_key()) fail(mark, "a key must be text");
    Open opened;
    opened.value.kind = kind;
    opened.value.position = position_of(mark);
    open_.push_back(std::move(opened));
  }

  void close() {
    Value value = std::move(open_.back().value);
    open_.pop_back();
    add(std::move(value));
  }

  void add(Value value) {
    if (open_.empty()) {
      root_ = std::move(value);
      return;
    }
    Open& parent = open_.back();
    if (parent.key) parent.value.keys.push_back(*std::exchange(parent.key, std::nullopt));
    parent.value.items.push_back(std::move(value));
  }

  void take_key(Key key) {
    Open& map = open_.back();
    for (const Key& earlier : map.value.keys) {
      if (earlier.text != key.text) continue;
      throw Error(file_, key.position, join_key(path(), key.text),
                  "duplicate key, first given in line " + std::to_string(earlier.position.line));
    }
    map.key = std::move(key);
  }

  [[nodiscard]] std::string path() const {
    std::string result;
    for (const Open& level : open_) {
      if (level.value.kind == Value::Kind::kList) {
        result = join_index(result, level.value.items.size());
      } else if (level.key) {
        result = join_key(result, level.key->text);
      }
    }
    return result;
  }

  void refuse_extras(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) const {
    if (anchor != 0) fail(mark, "anchors are not supported; write the value out");
    if (!tag.empty() && tag != "?" && tag != "!") fail(mark, "tags are not supported");
  }

  [[noreturn]] void fail(const YAML::Mark& mark, std::string_view reason) const {
    throw Error(file_, position_of(mark), shown_path(path()), reason);
  }

  std::string file_;
  std::vector<Open> open_;
  Value root_;
};

/// YAML forbids tabs in indentation, but the parser's message then speaks of something else.
std::string tab_hint(const std::string& text, int line) {
  std::istringstream lines(text);
  std::string at;
  for (int i = 0; i < line; ++i) std::getline(lines, at);
  const bool tab = at.find('\t') < at.find_first_not_of(" \t");
  return tab ? "; the line is indented with a tab, use spaces" : "";
}

std::string read_all(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw Error(path.string(), {}, "(file)", "is a directory");
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw Error(path.string(), {}, "(file)", std::system_category().message(errno));
  std::ostringstream text;
  text << stream.rdbuf();
  if (stream.bad()) throw Error(path.string(), {}, "(file)", "cannot be read");
  return text.str();
}

}  // namespace

Document parse_text(std::string_view file, const std::string& text) {
  ValueBuilder builder(file);
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    if (parser.HandleNextDocument(builder)) {
      ValueBuilder rest(file);
      if (parser.HandleNextDocument(rest)) {
        throw Error(file, {}, "(syntax)", "more than one document in the file");
      }
    }
  } catch (const YAML::Exception& error) {
    const Position at = error.mark.is_null() ? Position{} : position_of(error.mark);
    throw Error(file, at, "(syntax)", error.msg + tab_hint(text, at.line));
  }
  return {{std::string(file)}, builder.take_root()};
}

Document parse_file(const std::filesystem::path& path) {
  return parse_text(path.string(), read_all(path));
}

}  // namespace scarab::config
