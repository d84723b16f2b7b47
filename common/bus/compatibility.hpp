#pragma once

#include <dds/dds.h>

#include <string>
#include <vector>

namespace scarab::bus {

/// One policy because of which a writer and a reader of a topic do not meet.
struct Mismatch {
  std::string policy;   ///< as policy_name() has it, such as "reliability"
  std::string offered;  ///< by the writer, such as "best-effort"
  std::string asked;    ///< by the reader, such as "reliable"
};

/// The policies that keep a writer with QoS `offered` and a reader with QoS `asked` apart, by the
/// "requested versus offered" rules of the DDS standard (1.4, 2.2.3) and its rules for partitions
/// and data representations. Empty: they match. Types are not compared.
std::vector<Mismatch> mismatches(const dds_qos_t& offered, const dds_qos_t& asked);

}  // namespace scarab::bus
