#pragma once

#include <dds/dds.h>

#include <string>
#include <vector>

/// Single QoS policies of an announced endpoint, and their values in words.
namespace scarab::bus {

std::string to_text(dds_reliability_kind_t kind);
std::string to_text(dds_durability_kind_t kind);
std::string to_text(dds_ownership_kind_t kind);
std::string to_text(dds_liveliness_kind_t kind);
std::string to_text(dds_destination_order_kind_t kind);
std::string to_text(dds_presentation_access_scope_kind_t kind);

/// `20 ms`, `1 s`, `infinite`.
std::string duration_text(dds_duration_t ns);

/// What is not announced has the default of the DDS standard for readers.
dds_reliability_kind_t reliability_of(const dds_qos_t& qos);
dds_durability_kind_t durability_of(const dds_qos_t& qos);

/// Never empty: the default partition is the empty name.
std::vector<std::string> partitions_of(const dds_qos_t& qos);

}  // namespace scarab::bus
