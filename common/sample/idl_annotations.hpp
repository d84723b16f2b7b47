#pragma once

#include <cstdint>
#include <optional>

#include "common/sample/idl_cursor.hpp"
#include "common/sample/idl_declarations.hpp"

namespace scarab::sample {

/// What the annotations before a declaration say, as far as it changes the bytes of samples.
struct IdlAnnotations {
  bool key = false;
  bool optional = false;
  bool is_mutable = false;
  Extensibility extensibility = Extensibility::kFinal;
  std::optional<std::int64_t> value;  ///< of an enum's literal
  std::int64_t bit_bound = 32;
};

/// Takes all annotations at the cursor (IDL 4.2, 8.3); those of other meaning are passed over.
IdlAnnotations parse_annotations(IdlCursor& cursor, const IdlDeclarations& declared);

}  // namespace scarab::sample
