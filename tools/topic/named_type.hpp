#pragma once

#include <string>

#include "common/sample/type_model.hpp"
#include "tools/topic/session.hpp"

namespace scarab::topic {

/// The type of that name: one of the project's own, or what somebody in the domain writes or reads
/// by `end`. Throws Failure (type unknown), saying which may be meant, and Interrupted.
bus::TopicType find_named_type(Session& session, const std::string& name, Clock::time_point end);

/// The model of a type. Throws Failure (type unknown) for one with parts that sample::TypeModel
/// does not know.
sample::TypeModel understood(const bus::TopicType& type);

}  // namespace scarab::topic
