#pragma once

#include <string>

#include "common/sample/type_model.hpp"

namespace scarab::sample {

/// The struct `type_name` (scoped, such as scarab::RobotState) of an IDL text: the reverse of
/// idl_text(), so that the `omgidl` schemas of any log can be read.
///
/// Takes modules, structs (with bases and forward declarations), enums, typedefs, integer constants
/// with arithmetic, all of IDL's annotations; skips other constants, comments and preprocessor
/// lines. Throws Error `line N: ...` for text that is no IDL, for names that are not declared, and
/// for what TypeModel has no place for: unions, maps, bit sets, wide text, optional members,
/// mutable types.
TypeModel parse_idl(const std::string& idl, const std::string& type_name);

}  // namespace scarab::sample
