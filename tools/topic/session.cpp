#include "tools/topic/session.hpp"

#include <algorithm>
#include <array>

#include "tools/topic/topic_table.hpp"

namespace scarab::topic {

namespace {

using Clock = std::chrono::steady_clock;
using bus::DiscoveredEndpoint;

// Participants on one machine know each other within some 10 ms; of a stack of 30, within 1 s.
constexpr std::chrono::milliseconds kQuiet{300};

}  // namespace

Session::Session(const runtime::BusOptions& options)
    : participant_(options.participant("topic", 0)),
      discovery_(participant_),
      guard_(participant_),
      shutdown_(guard_),
      waitset_(participant_) {
  waitset_.attach(guard_);
  waitset_.attach(discovery_);
}

std::vector<DiscoveredEndpoint> Session::settle(std::chrono::milliseconds limit) {
  const auto end = Clock::now() + limit;
  while (!interrupted() && Clock::now() < end) {
    // While there is nobody at all, somebody may still be about to answer.
    const auto patience = others().empty() ? end - Clock::now() : Clock::duration(kQuiet);
    if (!waitset_.wait(patience)) break;
    discovery_.update();
  }
  return others();
}

std::vector<DiscoveredEndpoint> Session::wait_for_writers(const std::string& topic,
                                                          std::chrono::milliseconds limit) {
  const auto end = Clock::now() + limit;
  while (!interrupted()) {
    discovery_.update();
    std::vector<DiscoveredEndpoint> writers;
    for (const DiscoveredEndpoint& endpoint : others()) {
      const bool writes = endpoint.kind == bus::EndpointKind::kWriter;
      if (writes && endpoint.topic == topic) writers.push_back(endpoint);
    }
    if (!writers.empty()) return writers;
    if (Clock::now() >= end) break;
    waitset_.wait(end - Clock::now());
  }
  if (interrupted()) return {};
  std::string known;
  for (const std::string& name : written_topics(others())) {
    known += (known.empty() ? "" : ", ") + name;
  }
  throw bus::Error("no such topic: " + topic + " has no writer in domain " +
                   std::to_string(participant_.options().domain) +
                   "; there are: " + (known.empty() ? "none" : known));
}

std::vector<DiscoveredEndpoint> Session::others() const {
  dds_guid_t self{};
  bus::check(dds_get_guid(participant_.handle(), &self), "participant");
  std::vector<DiscoveredEndpoint> out;
  for (DiscoveredEndpoint& endpoint : discovery_.endpoints()) {
    const bool own = std::equal(endpoint.participant.begin(), endpoint.participant.end(), self.v);
    if (!own) out.push_back(std::move(endpoint));
  }
  return out;
}

}  // namespace scarab::topic
