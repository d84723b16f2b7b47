#pragma once

#include <dds/dds.h>

#include <memory>

#include "common/sample/type_model.hpp"

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

/// The model of a compiled or discovered topic type. Throws Error for one without type
/// information, and for what has no place in it: unions, maps, bit sets and masks, wide text,
/// optional members, mutable types.
sample::TypeModel model_of(const dds_topic_descriptor_t& descriptor);

}  // namespace scarab::bus
