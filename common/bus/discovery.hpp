#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "common/bus/entity.hpp"
#include "common/bus/participant.hpp"
#include "common/bus/topic_type.hpp"

namespace scarab::bus {

/// The 16 bytes that tell an endpoint from every other in the domain.
using Guid = std::array<std::uint8_t, 16>;

enum class EndpointKind { kWriter, kReader };

/// An endpoint somebody in the domain has announced.
struct DiscoveredEndpoint {
  EndpointKind kind = EndpointKind::kWriter;
  Guid guid{};
  Guid participant{};
  std::string topic;
  std::string type;  ///< the type's name, such as scarab::RobotState
  Peer peer;
  std::shared_ptr<const dds_qos_t> qos;
  dds_instance_handle_t handle = 0;  ///< what Cyclone calls it here
  bool sends_type = false;           ///< it sends type information along
};

/// Watches which endpoints there are in the domain, those of this process included.
class Discovery {
 public:
  explicit Discovery(Participant& participant);

  /// Takes in what was announced since the last call; returns the endpoints that are new.
  std::vector<DiscoveredEndpoint> update();

  /// The endpoints there are, as of the last update(), ordered by topic.
  std::vector<DiscoveredEndpoint> endpoints() const;

  /// The type of an endpoint: what its writer sends along, or, if it sends nothing, the project's
  /// own type of that name. Asks the writer's process for what is missing, for at most `timeout`.
  /// Throws Error naming the topic when there is no such information.
  TopicType type_of(const DiscoveredEndpoint& endpoint, std::chrono::nanoseconds timeout);

  /// Ready as long as announcements wait for update(); what a WaitSet waits for.
  std::array<dds_entity_t, 2> conditions() const;

 private:
  struct Source {
    Source(Participant& participant, EndpointKind of);
    EndpointKind kind;
    Entity reader;
    Entity condition;
  };

  void take(const Source& source, std::vector<DiscoveredEndpoint>& fresh);

  Participant& participant_;
  Source writers_;
  Source readers_;
  std::map<Guid, DiscoveredEndpoint> endpoints_;
};

}  // namespace scarab::bus
