#pragma once

#include <string>
#include <vector>

#include "common/sample/bytes.hpp"
#include "common/sample/type_model.hpp"

namespace scarab::sample {

/// A value as a person or a program wrote it, such as a YAML document: text, lists and maps without
/// a type.
struct WrittenValue {
  enum class Kind { kNothing, kText, kList, kMap };
  Kind kind = Kind::kNothing;
  std::string text;                 ///< of kText
  bool quoted = false;              ///< of kText: it can only be text, not a number
  std::vector<std::string> keys;    ///< of kMap; keys[i] names items[i]
  std::vector<WrittenValue> items;  ///< of kList and kMap
};

/// The bytes of the sample of a type that a value describes, in the representation and with the
/// padding that encode_sample() gives them.
///
/// Members that are left out, and nothing, are zero: false, empty text, an empty sequence, of an
/// enum the value 0 or else its first. Numbers are written as in JSON, those of floats also nan,
/// inf, -inf; enum values by name or number; 64-bit integers, and a struct of `sec` and `nanosec`,
/// may be `now`: then it is `now_ns`, the wall clock in ns since the Unix epoch.
///
/// Throws NoSuchMember for a name the type does not have, and Error otherwise, naming the path and
/// what is wrong: `position_rad: 3 elements, but it has 19`,
/// `header.tick: -1 is no unsigned long (0 to 4294967295)`.
Bytes build_cdr(const TypeModel& model, const WrittenValue& value, std::int64_t now_ns);

}  // namespace scarab::sample
