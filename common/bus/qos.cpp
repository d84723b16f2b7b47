#include "common/bus/qos.hpp"

#include <string>

namespace scarab::bus {

namespace {

// Writers wait for slow readers at most this long, then the write fails by name.
constexpr dds_duration_t kMaxBlocking = DDS_SECS(1);
constexpr dds_duration_t kStatusLease = DDS_SECS(1);

Qos common_qos(Profile profile) {
  Qos qos(dds_create_qos());
  dds_qset_reliability(qos.get(), DDS_RELIABILITY_RELIABLE, kMaxBlocking);
  dds_qset_durability(qos.get(), DDS_DURABILITY_TRANSIENT_LOCAL);
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, profile == Profile::kStatus ? 1 : int{kDepth});
  dds_qset_ownership(qos.get(), DDS_OWNERSHIP_SHARED);
  if (profile == Profile::kStatus) {
    dds_qset_liveliness(qos.get(), DDS_LIVELINESS_AUTOMATIC, kStatusLease);
  }
  return qos;
}

}  // namespace

Qos writer_qos(Profile profile) {
  Qos qos = common_qos(profile);
  dds_qset_writer_data_lifecycle(qos.get(), false);
  if (profile == Profile::kStream) {
    dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, int{kStreamDepth});
  }
  dds_qset_durability_service(qos.get(), 0, DDS_HISTORY_KEEP_LAST, 1, DDS_LENGTH_UNLIMITED,
                              DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED);
  return qos;
}

Qos reader_qos(Profile profile, const ReaderOptions& options) {
  Qos qos = common_qos(profile);
  if (profile == Profile::kStream) dds_qset_durability(qos.get(), DDS_DURABILITY_VOLATILE);
  if (options.depth) dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, *options.depth);
  if (options.keep_all) {
    dds_qset_history(qos.get(), DDS_HISTORY_KEEP_ALL, DDS_LENGTH_UNLIMITED);
    dds_qset_durability(qos.get(), DDS_DURABILITY_TRANSIENT_LOCAL);
  }
  if (options.best_effort) dds_qset_reliability(qos.get(), DDS_RELIABILITY_BEST_EFFORT, 0);
  return qos;
}

void set_peer(dds_qos_t& qos, const Peer& self) {
  const std::string text = encode_peer(self);
  dds_qset_userdata(&qos, text.data(), text.size());
}

Peer get_peer(const dds_qos_t* qos) {
  void* data = nullptr;
  std::size_t size = 0;
  if (qos == nullptr || !dds_qget_userdata(qos, &data, &size) || data == nullptr) return {};
  const Peer peer = decode_peer({static_cast<const char*>(data), size});
  dds_free(data);
  return peer;
}

const char* policy_name(std::uint32_t policy_id) {
  switch (policy_id) {
    case DDS_DURABILITY_QOS_POLICY_ID:
      return "durability";
    case DDS_PRESENTATION_QOS_POLICY_ID:
      return "presentation";
    case DDS_DEADLINE_QOS_POLICY_ID:
      return "deadline";
    case DDS_LATENCYBUDGET_QOS_POLICY_ID:
      return "latency budget";
    case DDS_OWNERSHIP_QOS_POLICY_ID:
      return "ownership";
    case DDS_LIVELINESS_QOS_POLICY_ID:
      return "liveliness";
    case DDS_PARTITION_QOS_POLICY_ID:
      return "partition";
    case DDS_RELIABILITY_QOS_POLICY_ID:
      return "reliability";
    case DDS_DESTINATIONORDER_QOS_POLICY_ID:
      return "destination order";
    case DDS_DATA_REPRESENTATION_QOS_POLICY_ID:
      return "data representation";
    case DDS_TYPE_CONSISTENCY_ENFORCEMENT_QOS_POLICY_ID:
      return "type consistency";
    default:
      return "unknown policy";
  }
}

}  // namespace scarab::bus
