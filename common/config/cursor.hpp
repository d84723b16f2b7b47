#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/config/document.hpp"
#include "common/config/range.hpp"

namespace scarab::config {

/// A place in a document: a value, and the path that led to it. Every read that does not find what
/// it wants throws Error at that place. Valid as long as the document is.
class Cursor {
 public:
  explicit Cursor(const Document& document);

  /// The value of a key of this map, if the key is there.
  [[nodiscard]] std::optional<Cursor> find(std::string_view key) const;
  /// The value of a key of this map; fails at this map if it is missing.
  [[nodiscard]] Cursor at(std::string_view key) const;
  /// The value a dotted path leads to, or the last one on the way that is there.
  [[nodiscard]] Cursor nearest(std::string_view path) const;
  /// The elements of this list, which must have `size` of them if that is given.
  [[nodiscard]] std::vector<Cursor> elements(std::optional<std::size_t> size = {}) const;
  /// The values of this map with their keys.
  [[nodiscard]] std::vector<std::pair<std::string, Cursor>> entries() const;
  /// Fails unless this is a map; fails at a key that is not among `known`.
  void expect_map_of(const std::vector<std::string_view>& known) const;

  [[nodiscard]] double number(const Range& range) const;
  [[nodiscard]] bool truth() const;
  [[nodiscard]] std::string text() const;
  /// Whole number within [min, max] of the type it is for, and within `range`.
  [[nodiscard]] long long signed_integer(long long min, long long max, const Range& range) const;
  [[nodiscard]] unsigned long long unsigned_integer(unsigned long long max,
                                                    const Range& range) const;
  /// Index of this text among `names`.
  [[nodiscard]] std::size_t one_of(const std::vector<std::string_view>& names) const;
  /// True for the plain word `absent`.
  [[nodiscard]] bool says_absent() const;

  [[noreturn]] void fail(std::string_view reason) const;
  /// Fails here, naming a key below this map.
  [[noreturn]] void fail_at(std::string_view key, std::string_view reason) const;

 private:
  Cursor(const Document& document, const Value& value, std::string path);
  [[noreturn]] void fail_at(Position position, std::string_view path,
                            std::string_view reason) const;
  [[noreturn]] void fail_expecting(std::string_view expected) const;
  [[nodiscard]] const std::string& plain_scalar(std::string_view expected) const;

  const Document* document_;
  const Value* value_;
  std::string path_;
};

}  // namespace scarab::config
