#pragma once

#include <cstdint>

#include "common/sample/idl_cursor.hpp"
#include "common/sample/idl_names.hpp"

namespace scarab::sample {

/// The value of the integer expression at the cursor (IDL 4.2, 7.4.1.4.3): numbers, constants,
/// + - * / % and parentheses. Throws Error for a name that is none of `constants`, and for values
/// beyond 64 bits.
std::int64_t evaluate(IdlCursor& cursor, const IdlNames<std::int64_t>& constants,
                      const IdlScope& scope);

}  // namespace scarab::sample
