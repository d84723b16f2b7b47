#pragma once

#include <dds/dds.h>

#include <string>
#include <vector>

#include "common/sample/type_model.hpp"

namespace scarab::bus {

/// The descriptor of one of the project's own topic types by its name ("scarab::RobotState"), for
/// logs and for writers that send no type information; null for another name.
const dds_topic_descriptor_t* find_known_type(const std::string& type_name);

/// The names of the project's own topic types.
std::vector<std::string> known_type_names();

}  // namespace scarab::bus
