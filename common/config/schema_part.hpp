#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/config/range.hpp"
#include "common/config/value.hpp"

/// The pieces of a JSON Schema, of which schema.hpp builds that of a struct.
namespace scarab::config {

/// The schema of one value in two parts, because a file that extends another need not be complete:
/// the shape that what is given must have, and the keys that a complete file has, both from this
/// value on.
struct SchemaPart {
  Value shape;
  Value needs;  ///< nothing if nothing is needed
};

[[nodiscard]] SchemaPart schema_of_text();
[[nodiscard]] SchemaPart schema_of_truth();
[[nodiscard]] SchemaPart schema_of_number(const Range& range);
/// A whole number of a type of `bits` bits.
[[nodiscard]] SchemaPart schema_of_integer(bool is_signed, int bits, const Range& range);
[[nodiscard]] SchemaPart schema_of_one_of(const std::vector<std::string_view>& names);
/// A list, of `size` elements if that is given. Its elements are complete in any file, since a list
/// is replaced whole.
[[nodiscard]] SchemaPart schema_of_list(SchemaPart element, std::optional<std::size_t> size);
/// A map from any text to such values.
[[nodiscard]] SchemaPart schema_of_map(SchemaPart value);
/// Such a value or the word `absent`.
[[nodiscard]] SchemaPart schema_or_absent(SchemaPart value);

/// A key of a struct.
struct SchemaKey {
  std::string name;
  SchemaPart value;
  std::optional<Value> fallback;  ///< what holds if the key is left out; required if there is none
};

/// A map with these keys and no other.
[[nodiscard]] SchemaPart schema_of_struct(std::vector<SchemaKey> keys);

/// Says the unit that the key's name ends in and the range.
void describe_value(SchemaPart& part, std::string_view key, const Range& range);

/// The whole schema as JSON: that of a file which may also begin with `extends`.
[[nodiscard]] std::string schema_text(SchemaPart root, std::string_view title);

}  // namespace scarab::config
