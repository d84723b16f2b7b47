#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace scarab::fastdds {

/// A service of the stack and its number, as endpoints carry it in their user data.
struct Peer {
  std::string service;
  std::uint32_t instance = 0;

  friend bool operator==(const Peer& a, const Peer& b) {
    return std::tie(a.service, a.instance) == std::tie(b.service, b.instance);
  }
};

/// `scarab:premotor:0`.
std::string user_data_of(const Peer& peer);
/// The reverse; a peer without a name for what is none.
Peer peer_of(const std::string& user_data);

/// How many instances of each service the stack has.
using Expectation = std::map<std::string, std::uint32_t>;
/// Reads `plant=1,premotor=2`; throws std::invalid_argument.
Expectation parse_expectation(const std::string& text);

/// Those of the expected instances of `service` that are not among `peers`, each as
/// `plant/0 <action>`.
std::vector<std::string> missing(const Expectation& expect, const std::string& service,
                                 const std::vector<Peer>& peers, const std::string& action);

}  // namespace scarab::fastdds
