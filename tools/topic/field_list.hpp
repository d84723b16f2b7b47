#pragma once

#include <string>

#include "common/sample/type_model.hpp"

namespace scarab::topic {

/// The paths to the parts of a type's samples that have values of their own, a line each, with
/// their types unless `names_only`. Of lists of structs those of the first element.
std::string field_list(const sample::TypeModel& model, bool names_only);

}  // namespace scarab::topic
