#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "common/mcap/reader.hpp"
#include "services/logger/core/sample_header.hpp"

namespace scarab::log {

/// A sample of the chain, as bytes with what its header says.
struct ChainSample {
  logger::SampleHeader header;
  mcap::Bytes cdr;
};

/// True when the two are byte-equal, the wall-clock stamp aside.
bool equal_but_stamp(const ChainSample& a, const ChainSample& b);

/// The samples of one topic by trial, each trial in the order of tick and simulated time.
using TrialSamples = std::map<std::uint32_t, std::vector<ChainSample>>;

/// All samples of a topic whose type begins with a Header. What a restarted service or a replica
/// said twice, equal but for the stamp, is there once. Throws mcap::FormatError for a sample that
/// does not begin with a header, and as mcap::Reader.
TrialSamples load_trial_samples(const mcap::Reader& reader, const std::string& topic);

}  // namespace scarab::log
