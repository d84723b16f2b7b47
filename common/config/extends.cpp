#include "common/config/extends.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "common/config/cursor.hpp"
#include "common/config/error.hpp"

namespace scarab::config {
namespace {

using Kind = Value::Kind;

constexpr std::string_view kExtends = "extends";

/// Never shortened, unlike in_quotes(): the end of a path is what tells files apart.
std::string named(const std::string& file) { return "'" + file + "'"; }

/// The file a document extends, as an error shows it, if it extends one. Fails at the key.
std::optional<std::filesystem::path> base_of(const Document& document) {
  if (document.root.kind != Kind::kMap) return std::nullopt;
  const auto at = Cursor(document).find(kExtends);
  if (!at) return std::nullopt;
  if (document.root.keys.front().text != kExtends) at->fail("must be the first key of the file");
  const std::filesystem::path folder = std::filesystem::path(document.files[0]).parent_path();
  std::filesystem::path base = (folder / at->text()).lexically_normal();
  if (!std::filesystem::is_regular_file(base)) at->fail("no file " + named(base.string()));
  return base;
}

/// Fails at the `extends` of the last document unless `base` may follow it.
void expect_new(const std::vector<Document>& chain, const std::filesystem::path& base) {
  const Cursor at = Cursor(chain.back()).at(kExtends);
  for (const Document& earlier : chain) {
    std::error_code ignored;  // of a file that has gone meanwhile
    if (std::filesystem::equivalent(earlier.files[0], base, ignored)) {
      at.fail("a circle: it leads back to " + named(earlier.files[0]));
    }
  }
  if (chain.size() > kMostBases) {
    at.fail("more than " + std::to_string(kMostBases) + " files extend each other");
  }
}

/// The file itself, then those it extends.
std::vector<Document> read_chain(const std::filesystem::path& path) {
  std::vector<Document> chain = {parse_file(path)};
  while (const auto base = base_of(chain.back())) {
    expect_new(chain, *base);
    chain.push_back(parse_file(*base));
    const Document& read = chain.back();
    if (read.root.kind != Kind::kMap) {
      throw Error(read.files[0], read.root.position, "(top level)",
                  "expected a map (extended by " + named(chain[chain.size() - 2].files[0]) + ")");
    }
  }
  return chain;
}

void set_file(Value& value, std::size_t file) {
  value.position.file = file;
  for (Key& key : value.keys) key.position.file = file;
  for (Value& item : value.items) set_file(item, file);
}

void remove_extends(Value& root) {
  if (root.kind != Kind::kMap || root.keys.empty() || root.keys.front().text != kExtends) return;
  root.keys.erase(root.keys.begin());
  root.items.erase(root.items.begin());
}

/// Lays `over` on `base`.
void merge(Value& base, Value over) {
  if (base.kind != Kind::kMap || over.kind != Kind::kMap) {
    base = std::move(over);
    return;
  }
  base.position = over.position;
  for (std::size_t i = 0; i < over.keys.size(); ++i) {
    const auto same = [&](const Key& key) { return key.text == over.keys[i].text; };
    const auto found = std::find_if(base.keys.begin(), base.keys.end(), same);
    if (found == base.keys.end()) {
      base.keys.push_back(std::move(over.keys[i]));
      base.items.push_back(std::move(over.items[i]));
    } else {
      const auto index = static_cast<std::size_t>(found - base.keys.begin());
      *found = std::move(over.keys[i]);
      merge(base.items[index], std::move(over.items[i]));
    }
  }
}

}  // namespace

Document read_extended(const std::filesystem::path& path) {
  std::vector<Document> chain = read_chain(path);
  Document result;
  for (std::size_t file = 0; file < chain.size(); ++file) {
    result.files.push_back(chain[file].files[0]);
    set_file(chain[file].root, file);
    remove_extends(chain[file].root);
  }
  result.root = std::move(chain.back().root);
  for (std::size_t file = chain.size() - 1; file > 0; --file) {
    merge(result.root, std::move(chain[file - 1].root));
  }
  return result;
}

}  // namespace scarab::config
