#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "common/bus/discovery.hpp"

namespace scarab::bus {

/// A writer and a reader of one topic that do not meet, and why.
struct EndpointFault {
  DiscoveredEndpoint writer;
  DiscoveredEndpoint reader;
  std::string policy;   ///< of the QoS, or "type name", or "type"
  std::string offered;  ///< by the writer
  std::string asked;    ///< by the reader
};

/// Tells the type behind an endpoint as IDL; empty: cannot say.
using TypeText = std::function<std::string(const DiscoveredEndpoint&)>;

/// Everything that keeps writers and readers among these endpoints apart. `type_text` is asked only
/// where two types have one name.
std::vector<EndpointFault> endpoint_faults(const std::vector<DiscoveredEndpoint>& endpoints,
                                           const TypeText& type_text);

/// The types behind endpoints as IDL, each asked for once.
class TypeTexts {
 public:
  /// Waits for each answer at most `patience`.
  TypeTexts(Discovery& discovery, std::chrono::nanoseconds patience)
      : discovery_(discovery), patience_(patience) {}

  /// Empty for an endpoint that does not tell its type.
  std::string operator()(const DiscoveredEndpoint& endpoint);

 private:
  Discovery& discovery_;
  std::chrono::nanoseconds patience_;
  std::map<Guid, std::string> texts_;
};

}  // namespace scarab::bus
