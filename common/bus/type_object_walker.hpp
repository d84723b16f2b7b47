#pragma once

#include "common/bus/topic_type.hpp"
#include "common/sample/type_model.hpp"

namespace scarab::bus {

/// Builds the tree of a topic type from the XTypes type objects in its descriptor (OMG
/// DDS-XTypes 1.3, 7.3.4, the complete ones: they have the names). Throws Error as
/// model_of().
sample::TypeRef walk_type_objects(const dds_topic_descriptor_t& descriptor);

/// Throws Error for a descriptor whose type information is damaged: bytes that are none, or type
/// objects that are not those their identifiers were computed from (7.3.1.2). Cyclone 0.10 believes
/// what stands in the descriptors it is given, and frees memory twice at some of it.
void check_type_objects(const dds_topic_descriptor_t& descriptor);

}  // namespace scarab::bus
