#pragma once

#include <cstdint>
#include <optional>

#include "common/sample/idl_cursor.hpp"
#include "common/sample/idl_declarations.hpp"

namespace scarab::sample {

/// The type at the cursor (IDL 4.2, 7.4.1.4.4): a primitive, string or sequence, or the name of a
/// declared type. Throws Error for what has no place in TypeModel.
IdlType parse_type_spec(IdlCursor& cursor, const IdlDeclarations& declared);

/// The type of the declarator whose name was just taken: its array dimensions, if any, around
/// `type`.
IdlType parse_dimensions(IdlCursor& cursor, const IdlDeclarations& declared, const IdlType& type);

/// The type of a constant, if it is a whole number; takes one word or more otherwise, too.
bool parse_whole_number_type(IdlCursor& cursor);

}  // namespace scarab::sample
