#pragma once

#include <optional>
#include <string>

#include "common/bus/type_model.hpp"
#include "common/mcap/reader.hpp"

namespace scarab::log {

/// The channel of a topic; null when the log has none.
const mcap::Channel* find_channel(const mcap::Reader& reader, const std::string& topic);

/// The type of a topic's samples, when it is one of the project's own; nothing for a foreign type
/// or an unknown topic.
std::optional<bus::TypeModel> find_type(const mcap::Reader& reader, const std::string& topic);

/// True when samples of the type begin with the chain's Header.
bool begins_with_header(const bus::TypeModel& type);

}  // namespace scarab::log
