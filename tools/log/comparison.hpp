#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/mcap/reader.hpp"

namespace scarab::log {

/// The topics that equal runs share to the byte.
const std::vector<std::string>& chain_topics();

/// How one topic compares in two logs.
struct TopicComparison {
  std::string topic;
  std::uint64_t equal_samples = 0;
  std::string difference;  ///< the first one in words, with its field; empty when there is none
};

/// Compares the samples of a topic trial by trial in the order of tick and simulated time: equal to
/// the byte, the header's wall-clock stamp aside. A trial or sample that only one log has is a
/// difference. Throws mcap::Error, also for a topic whose samples do not begin with a header.
TopicComparison compare_topic(const mcap::Reader& a, const mcap::Reader& b,
                              const std::string& topic);

}  // namespace scarab::log
