#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "common/config/document.hpp"
#include "common/config/emit.hpp"
#include "common/config/extends.hpp"
#include "common/config/reader.hpp"
#include "common/config/schema.hpp"
#include "common/config/writer.hpp"

/// Strict YAML configuration. A struct is described once, in its own namespace, and the description
/// serves for reading, for dumping, for error messages and for the schema that editors read:
///
///     template <class Fields>
///     void visit_fields(Fields& f, ServoConfig& c) {
///       f("kp_nm_rad", c.kp_nm_rad, config::kPositive);     // required, with its range
///       f.optional("label", c.label);                       // may be left out: the default stays
///     }
///
/// Members may be double, bool, integers, std::string, enumerations (with enum_names(E), see
/// traits.hpp), std::array<T, N>, T[N], std::vector<T>, std::map<std::string, T>, std::optional<T>
/// (a value or the word `absent`) and described structs. Conditions between keys go into
/// validate(const X&, const Check&), found in the same namespace and called after the struct has
/// been read. Angles are in rad in files as in memory.
namespace scarab::config {

namespace detail {

template <class T>
T read_document(const Document& document) {
  T result{};
  read(Cursor(document), result);
  return result;
}

}  // namespace detail

/// Reads a struct from a YAML file and the files it extends (extends.hpp). Throws Error
/// (`file:line:col: key: reason`) for a missing file, bad syntax, an unknown, duplicate or missing
/// key, a wrong type, a number out of range or not finite.
template <class T>
[[nodiscard]] T load(const std::filesystem::path& path) {
  return detail::read_document<T>(read_extended(path));
}

/// The same from text, which cannot extend a file; errors name it `file`.
template <class T>
[[nodiscard]] T load_text(std::string_view file, const std::string& text) {
  return detail::read_document<T>(parse_text(file, text));
}

/// YAML text of the whole value, whatever files it came from, that load() reads back to an equal
/// value: numbers in the shortest form that is exact.
template <class T>
[[nodiscard]] std::string dump(const T& value) {
  T copy =
      value;  // visit_fields() takes a mutable struct, so that one description serves both ways
  return emit(to_value(copy));
}

}  // namespace scarab::config
