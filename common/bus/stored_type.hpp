#pragma once

#include <string>

#include "common/bus/participant.hpp"
#include "common/bus/raw_cdr.hpp"
#include "common/bus/topic_type.hpp"

namespace scarab::bus {

/// A topic type as bytes, so that a log can be published again by a program that knows no type:
/// the type's name, and the XTypes type information and type mapping of its descriptor (XCDR2,
/// without header).
struct StoredType {
  std::string name;
  Bytes information;
  Bytes mapping;
};

/// Throws Error for a type without type information.
StoredType store_type(const dds_topic_descriptor_t& type);

/// The topic type of such bytes, as if a writer in the domain had announced it; the participant
/// keeps no trace of it. Throws Error naming the type for bytes that are no type information, or
/// that do not hold all of the type.
TopicType restore_type(Participant& participant, const StoredType& stored);

}  // namespace scarab::bus
