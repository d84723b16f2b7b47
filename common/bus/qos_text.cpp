#include "common/bus/qos_text.hpp"

#include "common/bus/policy_text.hpp"

namespace scarab::bus {

std::string qos_text(const dds_qos_t& qos) {
  dds_liveliness_kind_t liveliness = DDS_LIVELINESS_AUTOMATIC;
  dds_duration_t lease = DDS_INFINITY;
  dds_duration_t deadline = DDS_INFINITY;
  dds_ownership_kind_t ownership = DDS_OWNERSHIP_SHARED;
  dds_qget_liveliness(&qos, &liveliness, &lease);
  dds_qget_deadline(&qos, &deadline);
  dds_qget_ownership(&qos, &ownership);
  std::string out = to_text(reliability_of(qos)) + ", " + to_text(durability_of(qos));
  if (lease != DDS_INFINITY) out += ", liveliness " + duration_text(lease);
  if (deadline != DDS_INFINITY) out += ", deadline " + duration_text(deadline);
  if (ownership == DDS_OWNERSHIP_EXCLUSIVE) out += ", exclusive";
  for (const auto& partition : partitions_of(qos)) {
    if (!partition.empty()) out += ", partition " + partition;
  }
  return out;
}

}  // namespace scarab::bus
