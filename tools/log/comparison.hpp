#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/log/sample_comparison.hpp"
#include "tools/log/topic_samples.hpp"

namespace scarab::log {

/// Where two logs first differ on a topic.
struct Difference {
  enum class Kind { kValue, kOnlyInA, kOnlyInB };
  Kind kind = Kind::kValue;
  bool has_header = false;
  logger::SampleHeader header;        ///< of types that begin with one
  std::size_t index = 0;              ///< from 0; of its group, in order
  std::string instance;               ///< its key, as in SampleGroup
  std::uint64_t publish_time_ns = 0;  ///< in the log that has it; in a if both have
  FieldDifference field;              ///< of kValue
};

/// How one topic compares in two logs.
struct TopicComparison {
  std::string topic;
  std::uint64_t equal = 0;      ///< samples that both have, equal
  std::uint64_t different = 0;  ///< samples that both have, different
  std::uint64_t only_in_a = 0;
  std::uint64_t only_in_b = 0;
  std::optional<Difference> first;

  bool is_equal() const { return !first; }
};

/// Compares all samples of a topic: those with a header by trial, tick and simulated time, those
/// without one by their order in publish time, each instance of a keyed topic for itself. Keeps the
/// topic's samples of both logs in memory. Throws mcap::Error and bus::Error.
TopicComparison compare_topic(const Log& a, const Log& b, const std::string& topic,
                              const Lenience& lenience = {});

/// The topics of either log that runs are compared by: all but scarab/service_status, which tells
/// of processes and not of what they did.
std::vector<std::string> comparable_topics(const Log& a, const Log& b);

/// `trial 2, tick 3 (0.3 s)`, or `sample 7 (published at 12:04:01.500 UTC)`.
std::string place(const Difference& difference);

/// The difference in words, the logs called by these names: `trial 2, tick 3 (0.3 s): inputs[2]: 0
/// and 0.25`, `trial 2, tick 4 (0.4 s): only in a.mcap`.
std::string to_string(const Difference& difference, const std::string& a, const std::string& b);

}  // namespace scarab::log
