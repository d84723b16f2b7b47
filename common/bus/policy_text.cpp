#include "common/bus/policy_text.hpp"

#include <cstdint>

namespace scarab::bus {

std::string to_text(dds_reliability_kind_t kind) {
  return kind == DDS_RELIABILITY_RELIABLE ? "reliable" : "best-effort";
}

std::string to_text(dds_durability_kind_t kind) {
  switch (kind) {
    case DDS_DURABILITY_VOLATILE:
      return "volatile";
    case DDS_DURABILITY_TRANSIENT_LOCAL:
      return "transient-local";
    case DDS_DURABILITY_TRANSIENT:
      return "transient";
    case DDS_DURABILITY_PERSISTENT:
      return "persistent";
  }
  return "unknown";
}

std::string to_text(dds_ownership_kind_t kind) {
  return kind == DDS_OWNERSHIP_EXCLUSIVE ? "exclusive" : "shared";
}

std::string to_text(dds_liveliness_kind_t kind) {
  switch (kind) {
    case DDS_LIVELINESS_AUTOMATIC:
      return "automatic";
    case DDS_LIVELINESS_MANUAL_BY_PARTICIPANT:
      return "manual by participant";
    case DDS_LIVELINESS_MANUAL_BY_TOPIC:
      return "manual by topic";
  }
  return "unknown";
}

std::string to_text(dds_destination_order_kind_t kind) {
  return kind == DDS_DESTINATIONORDER_BY_SOURCE_TIMESTAMP ? "by source time" : "by reception time";
}

std::string to_text(dds_presentation_access_scope_kind_t kind) {
  switch (kind) {
    case DDS_PRESENTATION_INSTANCE:
      return "instance";
    case DDS_PRESENTATION_TOPIC:
      return "topic";
    case DDS_PRESENTATION_GROUP:
      return "group";
  }
  return "unknown";
}

std::string duration_text(dds_duration_t ns) {
  if (ns == DDS_INFINITY) return "infinite";
  if (ns % DDS_SECS(1) == 0) return std::to_string(ns / DDS_SECS(1)) + " s";
  if (ns % DDS_MSECS(1) == 0) return std::to_string(ns / DDS_MSECS(1)) + " ms";
  return std::to_string(ns / DDS_USECS(1)) + " us";
}

dds_reliability_kind_t reliability_of(const dds_qos_t& qos) {
  dds_reliability_kind_t kind = DDS_RELIABILITY_BEST_EFFORT;
  dds_duration_t blocking = 0;
  dds_qget_reliability(&qos, &kind, &blocking);
  return kind;
}

dds_durability_kind_t durability_of(const dds_qos_t& qos) {
  dds_durability_kind_t kind = DDS_DURABILITY_VOLATILE;
  dds_qget_durability(&qos, &kind);
  return kind;
}

std::vector<std::string> partitions_of(const dds_qos_t& qos) {
  std::uint32_t count = 0;
  char** names = nullptr;
  std::vector<std::string> out;
  if (dds_qget_partition(&qos, &count, &names)) {
    for (std::uint32_t i = 0; i < count; ++i) {
      out.emplace_back(names[i]);
      dds_free(names[i]);
    }
    dds_free(names);
  }
  if (out.empty()) out.emplace_back();
  return out;
}

}  // namespace scarab::bus
