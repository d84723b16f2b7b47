#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "services/logger/core/sample_header.hpp"
#include "tools/log/log.hpp"

namespace scarab::log {

/// A sample as bytes, with what says where it belongs.
struct Sample {
  logger::SampleHeader header;  ///< of types that begin with one
  std::uint64_t publish_time_ns = 0;
  mcap::Bytes cdr;
};

/// What samples are compared with each other: those of a trial (0 for types without header) and of
/// an instance (the values of its key, as JSON; empty for types without one).
using SampleGroup = std::pair<std::uint32_t, std::string>;

/// The samples of one topic, each group in order: by tick and simulated time where they have a
/// header, else by publish time.
using TopicSamples = std::map<SampleGroup, std::vector<Sample>>;

/// What identifies a sample within its group, where types have a header.
inline auto place_of(const Sample& sample) {
  return std::make_tuple(sample.header.tick, sample.header.sim_time_ns);
}

/// All samples of a topic. What a restarted service or a replica said twice, equal but for the
/// stamp in its header, is there once. Throws mcap::FormatError for a sample without the header its
/// type has, and as mcap::Reader.
TopicSamples load_samples(const Log& log, const std::string& topic);

/// True when the two are byte-equal, the header's wall-clock stamp aside if they have one.
bool equal_bytes(mcap::ByteView a, mcap::ByteView b, bool have_header);

}  // namespace scarab::log
