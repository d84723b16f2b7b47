#pragma once

#include "common/bus/type_model.hpp"

namespace scarab::bus {

/// Builds the tree of a topic type from the XTypes type objects in its descriptor (OMG
/// DDS-XTypes 1.3, 7.3.4, the complete ones: they have the names). Throws Error as
/// TypeModel::from_descriptor.
TypeRef walk_type_objects(const dds_topic_descriptor_t& descriptor);

}  // namespace scarab::bus
