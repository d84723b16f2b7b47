#pragma once

#include <string>

#include "common/mcap/records.hpp"

namespace scarab::logger {

std::string host_name();

/// The metadata record `scarab.host`: name, kernel, machine, processor, memory and the version of
/// Cyclone DDS. What the system does not tell is left out.
mcap::Metadata host_metadata();

}  // namespace scarab::logger
