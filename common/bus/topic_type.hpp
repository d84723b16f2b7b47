#pragma once

#include <dds/dds.h>

#include <memory>

namespace scarab::bus {

/// A topic type that is known at run time only.
using TopicType = std::shared_ptr<const dds_topic_descriptor_t>;

/// Takes over a descriptor that Cyclone made of discovered type information.
///
/// Cyclone 0.10 marks every string key of such a type as one of fixed size, and then writes beyond
/// the 16 bytes it keeps for those (it aborts at the first longer key); the mark is taken off here.
TopicType own_discovered(dds_topic_descriptor_t* made);

/// A descriptor that lives as long as the program.
TopicType borrow_compiled(const dds_topic_descriptor_t& compiled);

}  // namespace scarab::bus
