#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "common/bus/error.hpp"

/// Strings and sequences of the generated C types, without owning pointers and leaks.
namespace scarab::bus {

/// The text in a bounded string (char[N + 1]); at most N characters even if it is not terminated.
template <std::size_t Size>
std::string_view text(const char (&field)[Size]) {
  return {field, strnlen(field, Size)};
}

/// Puts `value` into a bounded string and fills the rest with zeros. Throws Error if it does not
/// fit.
template <std::size_t Size>
void assign(char (&field)[Size], std::string_view value) {
  if (value.size() >= Size) {
    throw Error("text of " + std::to_string(value.size()) + " bytes does not fit into " +
                std::to_string(Size - 1) + ": " + std::string(value));
  }
  std::fill_n(std::copy(value.begin(), value.end(), field), Size - value.size(), '\0');
}

/// The same, but cuts what does not fit, between two UTF-8 characters.
template <std::size_t Size>
void assign_truncated(char (&field)[Size], std::string_view value) {
  std::size_t size = std::min(value.size(), Size - 1);
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  while (size > 0 && size < value.size() && continues(value[size])) --size;
  assign(field, value.substr(0, size));
}

/// Lets an unbounded string field point to `value`, which stays the owner and must outlive the use
/// of the sample.
inline void borrow(char*& field, std::string& value) { field = value.data(); }

/// Lets a sequence field (dds_sequence_...) show the elements of `values`, which stays the owner
/// and must outlive the use of the sample.
template <class Sequence, class Element>
void borrow(Sequence& field, std::vector<Element>& values) {
  field._buffer = values.data();
  field._length = static_cast<std::uint32_t>(values.size());
  field._maximum = field._length;
  field._release = false;
}

/// A view of consecutive elements, for range-based for.
template <class Element>
struct View {
  const Element* first;
  std::size_t count;
  const Element* begin() const { return first; }
  const Element* end() const { return first + count; }
  std::size_t size() const { return count; }
  bool empty() const { return count == 0; }
  const Element& operator[](std::size_t i) const { return first[i]; }
};

/// The elements of a sequence field.
template <class Sequence>
auto elements(const Sequence& field) {
  using Element = std::remove_pointer_t<decltype(field._buffer)>;
  return View<Element>{field._buffer, field._length};
}

}  // namespace scarab::bus
