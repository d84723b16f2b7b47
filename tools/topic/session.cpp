#include "tools/topic/session.hpp"

#include <algorithm>
#include <set>

#include "tools/topic/failure.hpp"

namespace scarab::topic {

namespace {

using bus::DiscoveredEndpoint;
using bus::EndpointKind;

// The process of an endpoint answers within milliseconds, or not at all.
constexpr std::chrono::milliseconds kTypePatience{1000};

/// True while there is nobody at all, or somebody whose endpoints are not known yet. Participants
/// of Cyclone tell them at once and may have none; others answer with their next heartbeat, which
/// Fast DDS 2.9 sends after up to a second.
bool still_to_come(const DomainView& view) {
  constexpr std::uint8_t kCyclone = 0x10;
  std::set<bus::Guid> heard;
  for (const DiscoveredEndpoint& endpoint : view.endpoints) heard.insert(endpoint.participant);
  return heard.empty() ||
         std::any_of(view.participants.begin(), view.participants.end(), [&](const auto& entry) {
           return entry.first[1] != kCyclone && heard.count(entry.first) == 0;
         });
}

Failure no_such_topic(const std::string& topic, const DomainView& view, std::uint32_t domain,
                      bool writers_only) {
  std::string readers;
  for (const auto& reader : view.of_topic(topic, EndpointKind::kReader)) {
    readers += (readers.empty() ? "" : ", ") + view.name_of(reader);
  }
  if (writers_only && !readers.empty()) {
    return Failure(kExitNoTopic, topic + " has no writer; it is read by " + readers);
  }
  const std::vector<std::string> known = view.topics();
  const std::string where = "no topic " + topic + " in domain " + std::to_string(domain);
  if (known.empty()) return Failure(kExitNoTopic, where + "; it has none at all");
  std::string hint = did_you_mean(topic, known);
  if (hint.empty()) {
    for (const std::string& name : known) hint += (hint.empty() ? "; there are " : ", ") + name;
  }
  return Failure(kExitNoTopic, where + hint);
}

}  // namespace

Session::Session(const runtime::BusOptions& options)
    : participant_(options.participant("topic", 0)),
      discovery_(participant_),
      participants_(participant_),
      guard_(participant_),
      shutdown_(guard_),
      waitset_(participant_),
      output_([this] { return interrupted(); }) {
  waitset_.attach(guard_);
  waitset_.attach(discovery_);
}

bool Session::wait(Clock::time_point end) {
  // Looks up at least this often: whether somebody still reads what is printed.
  constexpr std::chrono::seconds kLongest{1};
  const auto now = Clock::now();
  waitset_.wait(std::min<Clock::duration>(std::max(end, now) - now, kLongest));
  arrivals_ += discovery_.update().size();
  participants_.update();
  return Clock::now() < end;
}

DomainView Session::view() const {
  DomainView out{participants_.all(), {}};
  out.participants.erase(participants_.self());
  for (DiscoveredEndpoint& endpoint : discovery_.endpoints()) {
    if (endpoint.participant != participants_.self()) out.endpoints.push_back(std::move(endpoint));
  }
  return out;
}

DomainView Session::settle(std::chrono::milliseconds limit, std::chrono::milliseconds quiet) {
  const auto end = after(limit);
  const auto quiet_end = [&] { return still_to_come(view()) ? end : after(quiet); };
  auto enough = quiet_end();
  while (!interrupted()) {
    const std::uint64_t before = arrivals_;
    const bool more = wait(std::min(end, enough));
    if (!more) return view();
    if (arrivals_ != before || still_to_come(view())) enough = quiet_end();
  }
  throw Interrupted{};
}

std::vector<DiscoveredEndpoint> Session::wait_for_writers(const std::string& topic,
                                                          Clock::time_point end) {
  bool more = true;
  while (!interrupted()) {
    auto writers = view().of_topic(topic, EndpointKind::kWriter);
    if (!writers.empty()) return writers;
    if (!more) throw no_such_topic(topic, view(), participant_.options().domain, true);
    more = wait(end);
  }
  throw Interrupted{};
}

std::vector<DiscoveredEndpoint> Session::wait_for_endpoints(const std::string& topic,
                                                            Clock::time_point end) {
  bool more = true;
  while (!interrupted()) {
    auto endpoints = view().of_topic(topic);
    if (!endpoints.empty()) return endpoints;
    if (!more) throw no_such_topic(topic, view(), participant_.options().domain, false);
    more = wait(end);
  }
  throw Interrupted{};
}

void Session::wait_for_readers(const std::string& topic, std::size_t count, Clock::time_point end) {
  bool more = true;
  while (!interrupted()) {
    const std::size_t found = view().of_topic(topic, EndpointKind::kReader).size();
    if (found >= count) return;
    if (!more) {
      throw Failure(kExitTimeout, topic + " has " + std::to_string(found) + " of " +
                                      std::to_string(count) + " readers that were waited for");
    }
    more = wait(end);
  }
  throw Interrupted{};
}

bus::TopicType Session::type_of(const std::vector<DiscoveredEndpoint>& endpoints) {
  std::string reason;
  for (const DiscoveredEndpoint& endpoint : endpoints) {
    try {
      return discovery_.type_of(endpoint, kTypePatience);
    } catch (const bus::Error& error) {
      if (reason.empty()) reason = error.what();
    }
  }
  throw Failure(kExitNoType, reason);
}

}  // namespace scarab::topic
