#include "tools/log/trial_samples.hpp"

#include <algorithm>
#include <tuple>

namespace scarab::log {
namespace {

bool earlier(const ChainSample& a, const ChainSample& b) {
  return std::tie(a.header.tick, a.header.sim_time_ns) <
         std::tie(b.header.tick, b.header.sim_time_ns);
}

bool repeats(const ChainSample& a, const ChainSample& b) {
  return a.header.tick == b.header.tick && a.header.sim_time_ns == b.header.sim_time_ns &&
         equal_but_stamp(a, b);
}

}  // namespace

bool equal_but_stamp(const ChainSample& a, const ChainSample& b) {
  return a.cdr.size() == b.cdr.size() &&
         std::equal(a.cdr.begin(), a.cdr.begin() + logger::kStampBegin, b.cdr.begin()) &&
         std::equal(a.cdr.begin() + logger::kStampEnd, a.cdr.end(),
                    b.cdr.begin() + logger::kStampEnd);
}

TrialSamples load_trial_samples(const mcap::Reader& reader, const std::string& topic) {
  TrialSamples trials;
  reader.for_each(
      [&](const mcap::Channel&, const mcap::Message& message) {
        const auto header = logger::read_sample_header(message.data.data(), message.data.size());
        if (!header) {
          throw mcap::FormatError(topic + ": a sample of " + std::to_string(message.data.size()) +
                                  " bytes does not begin with a header");
        }
        trials[header->trial].push_back({*header, mcap::copy_of(message.data)});
      },
      {topic});
  for (auto& [trial, samples] : trials) {
    std::stable_sort(samples.begin(), samples.end(), earlier);
    samples.erase(std::unique(samples.begin(), samples.end(), repeats), samples.end());
  }
  return trials;
}

}  // namespace scarab::log
