#include "common/bus/discovery.hpp"

#include <algorithm>
#include <string_view>

#include "common/bus/known_types.hpp"
#include "common/bus/loan.hpp"
#include "common/bus/made_descriptor.hpp"
#include "common/bus/qos.hpp"

namespace scarab::bus {

namespace {

dds_entity_t builtin_topic(EndpointKind kind) {
  return kind == EndpointKind::kWriter ? DDS_BUILTIN_TOPIC_DCPSPUBLICATION
                                       : DDS_BUILTIN_TOPIC_DCPSSUBSCRIPTION;
}

Guid guid_of(const dds_guid_t& from) {
  Guid out{};
  std::copy_n(from.v, out.size(), out.begin());
  return out;
}

/// DDS's own topics, on which discovery itself has readers.
bool is_builtin(std::string_view topic) { return topic.substr(0, 4) == "DCPS"; }

/// Null: the endpoint sends no type information. Valid as long as the announcement.
const dds_typeinfo_t* type_information(dds_builtintopic_endpoint_t& announcement) {
  const dds_typeinfo_t* information = nullptr;
  const dds_return_t code = dds_builtintopic_get_endpoint_type_info(&announcement, &information);
  return code == DDS_RETCODE_OK ? information : nullptr;
}

DiscoveredEndpoint discovered(EndpointKind kind, dds_builtintopic_endpoint_t& from,
                              dds_instance_handle_t handle) {
  Qos qos(dds_create_qos());
  dds_copy_qos(qos.get(), from.qos);
  return {kind,
          guid_of(from.key),
          guid_of(from.participant_key),
          from.topic_name,
          from.type_name,
          get_peer(from.qos),
          std::shared_ptr<const dds_qos_t>(std::move(qos)),
          handle,
          type_information(from) != nullptr};
}

/// Null: the endpoint has gone, or sends no type information. Valid as long as the loan.
const dds_typeinfo_t* type_information(const Loan& announcement) {
  if (announcement.size() == 0 || !announcement.info(0).valid_data) return nullptr;
  return type_information(*static_cast<dds_builtintopic_endpoint_t*>(announcement.sample(0)));
}

/// `code`: what came of asking for the type.
std::string why_unknown(bool has_information, dds_return_t code) {
  if (!has_information) {
    return "its writer sends no type information, and it is none of Scarab's own";
  }
  return code == DDS_RETCODE_UNSUPPORTED
             ? "Cyclone DDS cannot read such types (their keys: bounded text, or in a base)"
             : "its writer's process did not tell";
}

}  // namespace

Discovery::Source::Source(Participant& participant, EndpointKind of)
    : kind(of),
      reader(check(dds_create_reader(participant.handle(), builtin_topic(of), nullptr, nullptr),
                   "discovery")),
      condition(check(
          dds_create_readcondition(reader.handle(), DDS_NOT_READ_SAMPLE_STATE | DDS_ANY_VIEW_STATE |
                                                        DDS_ANY_INSTANCE_STATE),
          "discovery")) {}

Discovery::Discovery(Participant& participant)
    : participant_(participant),
      writers_(participant, EndpointKind::kWriter),
      readers_(participant, EndpointKind::kReader) {}

std::vector<DiscoveredEndpoint> Discovery::update() {
  std::vector<DiscoveredEndpoint> fresh;
  take(writers_, fresh);
  take(readers_, fresh);
  return fresh;
}

void Discovery::take(const Source& source, std::vector<DiscoveredEndpoint>& fresh) {
  // Read, not taken: type_of() reads the announcements again.
  while (true) {
    const Loan loan = Loan::read(source.condition.handle(), "discovery");
    for (std::size_t i = 0; i < loan.size(); ++i) {
      auto& endpoint = *static_cast<dds_builtintopic_endpoint_t*>(loan.sample(i));
      const dds_sample_info_t& info = loan.info(i);
      if (info.instance_state != DDS_ALIVE_INSTANCE_STATE) {
        endpoints_.erase(guid_of(endpoint.key));
      } else if (info.valid_data && !is_builtin(endpoint.topic_name)) {
        auto found = discovered(source.kind, endpoint, info.instance_handle);
        const bool is_new = endpoints_.insert_or_assign(found.guid, found).second;
        if (is_new) fresh.push_back(std::move(found));
      }
    }
    if (loan.size() < Loan::kCapacity) return;
  }
}

std::vector<DiscoveredEndpoint> Discovery::endpoints() const {
  std::vector<DiscoveredEndpoint> out;
  for (const auto& [guid, endpoint] : endpoints_) out.push_back(endpoint);
  std::stable_sort(out.begin(), out.end(), [](const auto& a, const auto& b) {
    return a.topic != b.topic ? a.topic < b.topic : a.peer < b.peer;
  });
  return out;
}

TopicType Discovery::type_of(const DiscoveredEndpoint& endpoint, std::chrono::nanoseconds timeout) {
  const Source& source = endpoint.kind == EndpointKind::kWriter ? writers_ : readers_;
  const Loan announcement =
      Loan::read_instance(source.reader.handle(), endpoint.handle, "discovery");
  const dds_typeinfo_t* information = type_information(announcement);
  dds_return_t code = DDS_RETCODE_NOT_FOUND;
  if (information != nullptr) {
    dds_topic_descriptor_t* descriptor = nullptr;
    code = make_descriptor(participant_.handle(), DDS_FIND_SCOPE_GLOBAL, *information,
                           timeout.count(), &descriptor);
    if (code == DDS_RETCODE_OK) return own_discovered(descriptor);
  }
  const dds_topic_descriptor_t* known = find_known_type(endpoint.type);
  if (known != nullptr) return borrow_compiled(*known);
  throw Error("type " + endpoint.type + " of " + endpoint.topic + ": " +
              why_unknown(information != nullptr, code));
}

std::array<dds_entity_t, 2> Discovery::conditions() const {
  return {writers_.condition.handle(), readers_.condition.handle()};
}

}  // namespace scarab::bus
