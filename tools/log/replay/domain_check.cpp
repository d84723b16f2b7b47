#include "tools/log/replay/domain_check.hpp"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <vector>

#include "common/bus/discovery.hpp"
#include "common/bus/waitset.hpp"
#include "common/runtime/tick_masters.hpp"

namespace scarab::log {
namespace {

/// All endpoints, once none has been announced for a while: there is nothing that says that there
/// are no more.
std::vector<bus::DiscoveredEndpoint> look_around(bus::Participant& participant) {
  constexpr std::chrono::milliseconds kSilence{150};
  constexpr std::chrono::seconds kLongest{2};
  bus::Discovery discovery(participant);
  bus::WaitSet wait_set(participant);
  wait_set.attach(discovery);
  const auto end = std::chrono::steady_clock::now() + kLongest;
  while (std::chrono::steady_clock::now() < end && wait_set.wait(kSilence)) discovery.update();
  discovery.update();
  return discovery.endpoints();
}

}  // namespace

void refuse_company(bus::Participant& participant, const std::set<std::string>& topics) {
  for (const bus::DiscoveredEndpoint& other : look_around(participant)) {
    if (topics.count(other.topic) == 0) continue;
    const bool is_command =
        other.topic == "scarab/joint_command" || other.topic == "scarab/operator";
    std::string company;
    if (other.kind == bus::EndpointKind::kWriter) {
      company = " is being written by ";
    } else if (is_command && runtime::is_tick_master(other.peer)) {
      company = " would be obeyed by ";
    } else {
      continue;
    }
    throw std::runtime_error(other.topic + company + bus::to_string(other.peer) +
                             ": replay into another --domain, leave the topic out (--except), or "
                             "say --force");
  }
}

}  // namespace scarab::log
