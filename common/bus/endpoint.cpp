#include "common/bus/endpoint.hpp"

#include <algorithm>

#include "common/bus/cyclone_log.hpp"

namespace scarab::bus {

namespace {

std::string cause(dds_return_t code, const CycloneLog& log) {
  const std::string said = log.text();
  return said.empty() ? dds_strretcode(code) : said;
}

using MatchedList = dds_return_t (*)(dds_entity_t, dds_instance_handle_t*, std::size_t);
using MatchedData = dds_builtintopic_endpoint_t* (*)(dds_entity_t, dds_instance_handle_t);

std::vector<Peer> matched_peers(dds_entity_t endpoint, MatchedList list, MatchedData data) {
  std::vector<dds_instance_handle_t> handles(16);
  std::size_t count = 0;
  while (true) {
    count = static_cast<std::size_t>(
        check(list(endpoint, handles.data(), handles.size()), "matched endpoints"));
    if (count <= handles.size()) break;
    handles.resize(count);
  }
  std::vector<Peer> peers;
  for (std::size_t i = 0; i < count; ++i) {
    // Null: gone between the two calls.
    dds_builtintopic_endpoint_t* found = data(endpoint, handles[i]);
    if (found == nullptr) continue;
    peers.push_back(get_peer(found->qos));
    dds_builtintopic_free_endpoint(found);
  }
  std::sort(peers.begin(), peers.end());
  return peers;
}

/// Cyclone 0.10 reports another type under the same topic as an incompatible "QoS": its type.
std::string mismatch(std::uint32_t policy_id, const std::string& topic) {
  if (policy_id == DDS_INVALID_QOS_POLICY_ID ||
      policy_id == DDS_TYPE_CONSISTENCY_ENFORCEMENT_QOS_POLICY_ID) {
    return "inconsistent type on " + topic;
  }
  return std::string("incompatible qos (") + policy_name(policy_id) + ") on " + topic;
}

}  // namespace

Endpoint::Endpoint(Participant& participant, const char* kind, const char* topic,
                   const dds_topic_descriptor_t& descriptor)
    : kind_(kind), topic_(topic) {
  const CycloneLog log;
  const dds_entity_t code =
      dds_create_topic(participant.handle(), &descriptor, topic, nullptr, nullptr);
  if (code < 0) throw Error(name() + ": " + cause(code, log));
  topic_entity_ = Entity(code);
}

void Endpoint::own(dds_entity_t entity) { entity_ = Entity(check(entity, name())); }

WriterEndpoint::WriterEndpoint(Participant& participant, const char* topic,
                               const dds_topic_descriptor_t& descriptor, Qos qos)
    : Endpoint(participant, "writer", topic, descriptor) {
  set_peer(*qos, participant.self());
  own(dds_create_writer(participant.handle(), topic_handle(), qos.get(), nullptr));
}

std::vector<Peer> WriterEndpoint::matched() const {
  return matched_peers(handle(), dds_get_matched_subscriptions, dds_get_matched_subscription_data);
}

std::vector<std::string> WriterEndpoint::faults() const {
  dds_offered_incompatible_qos_status_t status{};
  check(dds_get_offered_incompatible_qos_status(handle(), &status), name());
  if (status.total_count == 0) return {};
  return {mismatch(status.last_policy_id, topic())};
}

void WriterEndpoint::flush() { dds_write_flush(handle()); }

void WriterEndpoint::send(const void* sample, dds_time_t source_ns) {
  stage(sample, source_ns);
  flush();
}

void WriterEndpoint::stage(const void* sample, dds_time_t source_ns) {
  const dds_return_t code = dds_write_ts(handle(), sample, source_ns);
  if (code == DDS_RETCODE_TIMEOUT) {
    std::string readers;
    for (const Peer& peer : matched()) readers += (readers.empty() ? "" : ", ") + to_string(peer);
    throw Error(name() + ": readers do not acknowledge: " + readers);
  }
  check(code, name());
}

CheckedWriter::CheckedWriter(Participant& participant, const char* topic,
                             const dds_topic_descriptor_t& descriptor, Profile profile)
    : WriterEndpoint(participant, topic, descriptor, writer_qos(profile)), check_(descriptor) {}

void CheckedWriter::check(const void* sample) const {
  try {
    check_.check(sample);
  } catch (const Error& error) {
    throw Error(name() + ": " + error.what());
  }
}

void CheckedWriter::write_sample(const void* sample) {
  check(sample);
  std::vector<std::byte> buffer;
  send(check_.without_padding(sample, buffer), dds_time());
}

void CheckedWriter::stage_sample(const void* sample) {
  check(sample);
  std::vector<std::byte> buffer;
  stage(check_.without_padding(sample, buffer), dds_time());
}

void CheckedWriter::dispose_sample(const void* sample) {
  bus::check(dds_dispose(handle(), sample), name());
  flush();
}

ReaderEndpoint::ReaderEndpoint(Participant& participant, const char* topic,
                               const dds_topic_descriptor_t& descriptor, Qos qos)
    : Endpoint(participant, "reader", topic, descriptor) {
  set_peer(*qos, participant.self());
  own(dds_create_reader(participant.handle(), topic_handle(), qos.get(), nullptr));
  condition_ = Entity(check(dds_create_readcondition(handle(), DDS_ANY_STATE), name()));
}

std::vector<Peer> ReaderEndpoint::matched() const {
  return matched_peers(handle(), dds_get_matched_publications, dds_get_matched_publication_data);
}

std::vector<std::string> ReaderEndpoint::faults() const {
  std::vector<std::string> out;
  dds_requested_incompatible_qos_status_t mismatched{};
  check(dds_get_requested_incompatible_qos_status(handle(), &mismatched), name());
  if (mismatched.total_count > 0) out.push_back(mismatch(mismatched.last_policy_id, topic()));
  dds_sample_lost_status_t lost{};
  check(dds_get_sample_lost_status(handle(), &lost), name());
  if (lost.total_count > 0) {
    out.push_back(std::to_string(lost.total_count) + " samples lost on " + topic());
  }
  return out;
}

}  // namespace scarab::bus
