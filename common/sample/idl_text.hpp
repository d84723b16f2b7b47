#pragma once

#include <string>

#include "common/sample/type_model.hpp"

namespace scarab::sample {

/// The IDL of a type and of all it is made of: one self-contained text, types before their use,
/// without absolute scopes, hexadecimal constants or preprocessor lines, so that every reader of
/// MCAP files takes it as an `omgidl` schema.
std::string idl_text(const TypeModel& model);

/// The type as it is written in a member's declaration, without array dimensions: `double`,
/// `sequence<scarab::Contact, 96>`, `string<127>`.
std::string idl_type_name(const Type& type);

}  // namespace scarab::sample
