#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tools/topic/domain_view.hpp"

namespace scarab::topic {

/// A participant of the domain.
struct ProcessEntry {
  bus::DiscoveredParticipant participant;
  std::string vendor;
  std::size_t writers = 0;
  std::size_t readers = 0;
};

/// Everybody in the domain, ordered by host, service, program and process number.
std::vector<ProcessEntry> process_list(const DomainView& view);

std::string process_table(const std::vector<ProcessEntry>& processes);
std::string process_json(const std::vector<ProcessEntry>& processes);

}  // namespace scarab::topic
