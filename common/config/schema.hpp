#pragma once

#include <iterator>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "common/config/range.hpp"
#include "common/config/schema_part.hpp"
#include "common/config/traits.hpp"
#include "common/config/writer.hpp"

/// A JSON Schema for editors, from the descriptions that also read and dump. It is of draft 7,
/// which editors know best, and says all that read() asks of one value: keys, types, ranges, sizes,
/// names. What it cannot say are the conditions of validate(); how YAML writes a number (`0x10` is
/// an integer to an editor, and refused here); and of a file that extends another, whether the
/// whole is complete.
namespace scarab::config {

template <class T>
[[nodiscard]] SchemaPart schema_of(T& member, const Range& range = kAny);

/// Visitor that collects what each key of a struct takes.
class FieldSchema {
 public:
  template <class T>
  void operator()(std::string_view key, T& member, const Range& range = kAny) {
    add(key, member, range);
  }
  template <class T>
  void optional(std::string_view key, T& member, const Range& range = kAny) {
    add(key, member, range);
    keys_.back().fallback = to_value(member);
  }
  [[nodiscard]] SchemaPart take() { return schema_of_struct(std::move(keys_)); }

 private:
  template <class T>
  void add(std::string_view key, T& member, const Range& range) {
    SchemaPart value = schema_of(member, range);
    describe_value(value, key, range);
    keys_.push_back({std::string(key), std::move(value), {}});
  }

  std::vector<SchemaKey> keys_;
};

/// What read() accepts for such a member.
template <class T>
SchemaPart schema_of(T& member, const Range& range) {
  if constexpr (kIsDescribed<T>) {
    FieldSchema fields;
    visit_fields(fields, member);
    return fields.take();
  } else if constexpr (kIsFixedList<T>) {
    return schema_of_list(schema_of(member[0], range), std::size(member));
  } else if constexpr (kIsVector<T>) {
    typename T::value_type element{};
    return schema_of_list(schema_of(element, range), {});
  } else if constexpr (kIsStringMap<T>) {
    typename T::mapped_type value{};
    return schema_of_map(schema_of(value, range));
  } else if constexpr (kIsOptional<T>) {
    typename T::value_type value{};
    return schema_or_absent(schema_of(value, range));
  } else if constexpr (std::is_enum_v<T>) {
    return schema_of_one_of(names_of<T>());
  } else if constexpr (std::is_same_v<T, bool>) {
    return schema_of_truth();
  } else if constexpr (std::is_same_v<T, std::string>) {
    return schema_of_text();
  } else if constexpr (std::is_same_v<T, double>) {
    return schema_of_number(range);
  } else {
    static_assert(std::is_integral_v<T>, "no visit_fields() or enum_names() found for this type");
    return schema_of_integer(std::is_signed_v<T>, 8 * static_cast<int>(sizeof(T)), range);
  }
}

/// JSON Schema of a file from which load<T>() reads.
template <class T>
[[nodiscard]] std::string schema(std::string_view title) {
  T value{};
  return schema_text(schema_of(value), title);
}

}  // namespace scarab::config
