#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "common/bus/endpoint.hpp"
#include "common/runtime/expectation.hpp"

namespace scarab::runtime {

/// Which peers a service's endpoints need before it can say ready, and which of them are not
/// matched yet.
class PeerCheck {
 public:
  explicit PeerCheck(Expectation expect) : expect_(std::move(expect)) {}

  /// Our endpoint, which must outlive this, needs all expected instances of `service` at its other
  /// end. A service that is not expected is not needed. Of writers there may be no more than
  /// expected: nobody could tell whose word counts.
  void need(const bus::WriterEndpoint& writer, const std::string& service);
  void need(const bus::ReaderEndpoint& reader, const std::string& service);

  /// One phrase for each peer that is missing ("logger/0 to read scarab/behaviour") or too many
  /// ("only 1 premotor to write scarab/joint_command (found 2)"), and for each reason why an
  /// endpoint did not match
  /// ("inconsistent type on scarab/behaviour"); empty: all is well.
  [[nodiscard]] std::vector<std::string> unmet() const;

 private:
  struct Need {
    std::string service;
    std::string action;  // "to read scarab/behaviour"
    std::function<std::vector<bus::Peer>()> matched;
    std::function<std::vector<std::string>()> faults;
    bool limited;  // no more of them than expected
  };
  void check(const Need& need, std::vector<std::string>& unmet) const;

  Expectation expect_;
  std::vector<Need> needs_;
};

/// `a, b and c`.
std::string join(const std::vector<std::string>& phrases);

}  // namespace scarab::runtime
