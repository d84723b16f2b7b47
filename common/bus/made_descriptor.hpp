#pragma once

#include <dds/dds.h>

namespace scarab::bus {

/// Makes the descriptor of a type from type information, with what the domain's type library or
/// (`scope` global) other processes know of it: dds_create_topic_descriptor, but for types at which
/// Cyclone 0.10 ends the process. Those with two or more keys of which one is in a base struct are
/// refused with DDS_RETCODE_UNSUPPORTED: it follows a null pointer when it sorts them.
dds_return_t make_descriptor(dds_entity_t participant, dds_find_scope_t scope,
                             const dds_typeinfo_t& information, dds_duration_t timeout,
                             dds_topic_descriptor_t** made);

}  // namespace scarab::bus
