#pragma once

#include <dds/dds.h>

#include <string>

namespace scarab::bus {

/// The policies of an announced endpoint in words: `reliable, transient-local, liveliness 1 s`.
/// History is not announced.
std::string qos_text(const dds_qos_t& qos);

}  // namespace scarab::bus
