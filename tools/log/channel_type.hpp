#pragma once

#include "tools/log/log.hpp"

namespace scarab::log {

/// How the messages of a channel are read: by the schema that the file has for it (`omgidl` or
/// `ros2msg`, with CDR messages), or by the project's own type of that name; `schema` null: it has
/// none.
LogChannel read_channel(const mcap::Channel& channel, const mcap::Schema* schema);

/// True when samples of the type begin with the chain's Header.
bool begins_with_header(const sample::TypeModel& type);

}  // namespace scarab::log
