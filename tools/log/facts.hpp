#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tools/log/log.hpp"

namespace scarab::log {

struct FileFacts {
  std::string path;
  std::string library;
  std::string profile;
  bool closed = false;
  std::string damage;
  std::uint64_t bytes_lost = 0;
  std::uint64_t size = 0;
  std::uint64_t chunks = 0;
  std::uint64_t chunk_bytes = 0;       ///< uncompressed
  std::set<std::string> compressions;  ///< of its chunks; `none` among them
  std::uint64_t messages = 0;
  std::uint64_t start_ns = 0;  ///< log time of the first message
  std::uint64_t end_ns = 0;
  std::vector<mcap::AttachmentIndex> attachments;
  std::vector<mcap::Metadata> metadata;
};

struct TopicFacts {
  std::string topic;
  std::string type;
  std::string no_type;  ///< why its samples cannot be shown; empty: they can
  std::uint64_t messages = 0;
  double rate_hz = 0;   ///< over the time from the log's first to its last message
  std::string writers;  ///< such as `plant/0`; empty: not recorded
  std::map<std::string, std::string> qos;  ///< of the writers, in words; empty: not recorded
  std::uint64_t dropped = 0;               ///< samples that the recorder could not keep
};

struct TrialFacts {
  std::uint32_t trial = 0;
  std::string strategy;  ///< empty: the log does not have its scarab/trial
  std::uint32_t first_tick = 0;
  std::uint32_t last_tick = 0;
  std::uint64_t ticks = 0;
  double sim_time_s = 0;
  std::optional<bool> real_time;  ///< paced by the wall clock, not in lockstep
};

/// What a log holds.
struct LogFacts {
  std::vector<FileFacts> files;
  std::vector<TopicFacts> topics;
  std::vector<TrialFacts> trials;
  std::uint64_t messages = 0;
  std::uint64_t dropped = 0;
  std::uint64_t start_ns = 0;
  std::uint64_t end_ns = 0;
};

/// Reads all that a log says of itself, and scarab/robot_state for the trials. `progress` is told
/// of the reading.
LogFacts gather_facts(const Log& log, const mcap::Progress& progress = {});

}  // namespace scarab::log
