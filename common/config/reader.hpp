#pragma once

#include <iterator>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "common/config/check.hpp"
#include "common/config/cursor.hpp"
#include "common/config/range.hpp"
#include "common/config/traits.hpp"

/// Reading: fills described structs from a document.
namespace scarab::config {

/// Visitor that only notes the keys of a struct.
class KeyList {
 public:
  template <class T>
  void operator()(std::string_view key, T& /*member*/, const Range& /*range*/ = kAny) {
    keys_.push_back(key);
  }
  template <class T>
  void optional(std::string_view key, T& /*member*/, const Range& /*range*/ = kAny) {
    keys_.push_back(key);
  }
  [[nodiscard]] const std::vector<std::string_view>& keys() const { return keys_; }

 private:
  std::vector<std::string_view> keys_;
};

template <class T>
void read(const Cursor& at, T& out, const Range& range = kAny);

/// Visitor that fills the members of a struct from a map.
class FieldReader {
 public:
  explicit FieldReader(Cursor at) : at_(std::move(at)) {}

  /// A required key.
  template <class T>
  void operator()(std::string_view key, T& member, const Range& range = kAny) {
    read(at_.at(key), member, range);
  }
  /// A key that may be left out; the member then keeps its default.
  template <class T>
  void optional(std::string_view key, T& member, const Range& range = kAny) {
    if (const auto value = at_.find(key)) read(*value, member, range);
  }

 private:
  Cursor at_;
};

namespace detail {

template <class X>
void read_struct(const Cursor& at, X& out) {
  // Unknown keys first: a misspelt key is also a missing one, and the misspelling is what helps.
  KeyList known;
  visit_fields(known, out);
  at.expect_map_of(known.keys());
  FieldReader reader(at);
  visit_fields(reader, out);
}

template <class T>
void read_integer(const Cursor& at, T& out, const Range& range) {
  using Limits = std::numeric_limits<T>;
  if constexpr (std::is_signed_v<T>) {
    out = static_cast<T>(at.signed_integer(Limits::min(), Limits::max(), range));
  } else {
    out = static_cast<T>(at.unsigned_integer(Limits::max(), range));
  }
}

template <class T>
void read_list(const Cursor& at, T& out, const Range& range) {
  if constexpr (kIsVector<T>) {
    out.clear();
    for (const Cursor& element : at.elements()) read(element, out.emplace_back(), range);
  } else {
    const std::vector<Cursor> elements = at.elements(std::size(out));
    for (std::size_t i = 0; i < elements.size(); ++i) read(elements[i], out[i], range);
  }
}

}  // namespace detail

/// Fills `out` from the value at `at`. Throws Error at the first thing that does not fit. `range`
/// holds for a number or for every number of a list, map or optional.
template <class T>
void read(const Cursor& at, T& out, const Range& range) {
  if constexpr (kIsDescribed<T>) {
    detail::read_struct(at, out);
  } else if constexpr (kIsFixedList<T> || kIsVector<T>) {
    detail::read_list(at, out, range);
  } else if constexpr (kIsStringMap<T>) {
    out.clear();
    for (const auto& [key, value] : at.entries()) read(value, out[key], range);
  } else if constexpr (kIsOptional<T>) {
    out.reset();
    if (!at.says_absent()) read(at, out.emplace(), range);
  } else if constexpr (std::is_enum_v<T>) {
    const std::vector<std::string_view> names = names_of<T>();
    out = enum_names(T{})[at.one_of(names)].second;
  } else if constexpr (std::is_same_v<T, bool>) {
    out = at.truth();
  } else if constexpr (std::is_same_v<T, std::string>) {
    out = at.text();
  } else if constexpr (std::is_same_v<T, double>) {
    out = at.number(range);
  } else {
    static_assert(std::is_integral_v<T>, "no visit_fields() or enum_names() found for this type");
    detail::read_integer(at, out, range);
  }
  if constexpr (kHasValidation<T>) validate(static_cast<const T&>(out), Check(at));
}

}  // namespace scarab::config
