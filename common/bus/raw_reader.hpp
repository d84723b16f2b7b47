#pragma once

#include <functional>
#include <vector>

#include "common/bus/discovery.hpp"
#include "common/bus/endpoint.hpp"
#include "common/bus/raw_cdr.hpp"

namespace scarab::bus {

struct RawReaderOptions {
  /// Also what writers keep for late joiners. Without it the first sample after the match may be
  /// missed.
  bool history = true;
};

/// Reads any topic as bytes, without knowing its type at compile time. Asks for what its writers
/// offer and keeps every sample until it is taken.
class RawReader : public ReaderEndpoint {
 public:
  /// `writers`: those known of the topic, at least one; the reader's QoS is the strictest that
  /// matches all.
  RawReader(Participant& participant, const std::vector<DiscoveredEndpoint>& writers,
            const TopicType& type, const RawReaderOptions& options = {});

  /// Calls f for each waiting sample, in the order of reception; returns how many.
  /// `enough` as in take_raw.
  std::size_t take(const std::function<void(const RawSample&)>& f,
                   std::size_t enough = std::numeric_limits<std::size_t>::max()) {
    return take_raw(handle(), f, enough);
  }
};

}  // namespace scarab::bus
