#include "common/bus/raw_reader.hpp"

#include <algorithm>
#include <set>
#include <string>

namespace scarab::bus {

namespace {

/// What a reader may ask for so that one writer matches.
void relax_for(const dds_qos_t& offered, dds_qos_t& qos) {
  dds_reliability_kind_t reliability = DDS_RELIABILITY_BEST_EFFORT;
  dds_durability_kind_t durability = DDS_DURABILITY_VOLATILE;
  dds_durability_kind_t asked = DDS_DURABILITY_VOLATILE;
  dds_duration_t blocking = 0;
  if (!dds_qget_reliability(&offered, &reliability, &blocking) ||
      reliability == DDS_RELIABILITY_BEST_EFFORT) {
    dds_qset_reliability(&qos, DDS_RELIABILITY_BEST_EFFORT, 0);
  }
  dds_qget_durability(&offered, &durability);
  dds_qget_durability(&qos, &asked);
  dds_qset_durability(&qos, std::min(durability, asked));
}

/// Ownership and data representation have to be the writer's.
void copy_from(const dds_qos_t& offered, dds_qos_t& qos) {
  dds_ownership_kind_t ownership = DDS_OWNERSHIP_SHARED;
  if (dds_qget_ownership(&offered, &ownership)) dds_qset_ownership(&qos, ownership);
  std::uint32_t count = 0;
  dds_data_representation_id_t* ids = nullptr;
  if (dds_qget_data_representation(&offered, &count, &ids)) {
    dds_qset_data_representation(&qos, count, ids);
    dds_free(ids);
  }
}

void add_partitions(const dds_qos_t& offered, std::set<std::string>& names) {
  std::uint32_t count = 0;
  char** raw = nullptr;
  if (!dds_qget_partition(&offered, &count, &raw)) return;
  for (std::uint32_t i = 0; i < count; ++i) {
    names.insert(raw[i]);
    dds_free(raw[i]);
  }
  dds_free(raw);
}

Qos raw_qos(const std::vector<DiscoveredEndpoint>& writers, const RawReaderOptions& options) {
  Qos qos(dds_create_qos());
  dds_qset_reliability(qos.get(), DDS_RELIABILITY_RELIABLE, 0);
  dds_qset_durability(qos.get(),
                      options.history ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_ALL, DDS_LENGTH_UNLIMITED);
  std::set<std::string> partitions;
  for (const DiscoveredEndpoint& writer : writers) {
    relax_for(*writer.qos, *qos);
    copy_from(*writer.qos, *qos);
    add_partitions(*writer.qos, partitions);
  }
  std::vector<const char*> names;
  for (const std::string& name : partitions) names.push_back(name.c_str());
  if (!names.empty()) {
    dds_qset_partition(qos.get(), static_cast<std::uint32_t>(names.size()), names.data());
  }
  return qos;
}

}  // namespace

RawReader::RawReader(Participant& participant, const std::vector<DiscoveredEndpoint>& writers,
                     const TopicType& type, const RawReaderOptions& options)
    : ReaderEndpoint(participant, writers.at(0).topic.c_str(), *type, raw_qos(writers, options)) {}

}  // namespace scarab::bus
