#include "common/bus/qos_text.hpp"

#include <cstdint>

namespace scarab::bus {

namespace {

std::string seconds_text(dds_duration_t ns) {
  const std::string ms = std::to_string(ns / 1000000);
  return ns % 1000000000 == 0 ? std::to_string(ns / 1000000000) + " s" : ms + " ms";
}

const char* durability_text(dds_durability_kind_t kind) {
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
  return "unknown durability";
}

std::string partitions_text(const dds_qos_t& qos) {
  std::uint32_t count = 0;
  char** names = nullptr;
  if (!dds_qget_partition(&qos, &count, &names)) return {};
  std::string out;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (*names[i] != '\0') out += std::string(", partition ") + names[i];
    dds_free(names[i]);
  }
  dds_free(names);
  return out;
}

}  // namespace

std::string qos_text(const dds_qos_t& qos) {
  dds_reliability_kind_t reliability = DDS_RELIABILITY_BEST_EFFORT;
  dds_duration_t blocking = 0;
  dds_durability_kind_t durability = DDS_DURABILITY_VOLATILE;
  dds_liveliness_kind_t liveliness = DDS_LIVELINESS_AUTOMATIC;
  dds_duration_t lease = DDS_INFINITY;
  dds_duration_t deadline = DDS_INFINITY;
  dds_ownership_kind_t ownership = DDS_OWNERSHIP_SHARED;
  dds_qget_reliability(&qos, &reliability, &blocking);
  dds_qget_durability(&qos, &durability);
  dds_qget_liveliness(&qos, &liveliness, &lease);
  dds_qget_deadline(&qos, &deadline);
  dds_qget_ownership(&qos, &ownership);
  std::string out = reliability == DDS_RELIABILITY_RELIABLE ? "reliable" : "best-effort";
  out += std::string(", ") + durability_text(durability);
  if (lease != DDS_INFINITY) out += ", liveliness " + seconds_text(lease);
  if (deadline != DDS_INFINITY) out += ", deadline " + seconds_text(deadline);
  if (ownership == DDS_OWNERSHIP_EXCLUSIVE) out += ", exclusive";
  return out + partitions_text(qos);
}

}  // namespace scarab::bus
