#include "tests/interop/fastdds/peer.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace scarab::fastdds {
namespace {

const std::string kPrefix = "scarab:";

/// Throws std::invalid_argument for what is no whole number.
std::uint32_t number(const std::string& text) {
  const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  if (!digits || text.size() > 9) throw std::invalid_argument("'" + text + "' is no number");
  return static_cast<std::uint32_t>(std::stoul(text));
}

}  // namespace

std::string user_data_of(const Peer& peer) {
  return kPrefix + peer.service + ":" + std::to_string(peer.instance);
}

Peer peer_of(const std::string& user_data) try {
  const auto colon = user_data.rfind(':');
  if (user_data.compare(0, kPrefix.size(), kPrefix) != 0 || colon < kPrefix.size()) return {};
  return {user_data.substr(kPrefix.size(), colon - kPrefix.size()),
          number(user_data.substr(colon + 1))};
} catch (const std::invalid_argument&) {
  return {};
}

Expectation parse_expectation(const std::string& text) {
  Expectation expect;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const auto equals = part.find('=');
    if (equals == std::string::npos) throw std::invalid_argument("'" + part + "' is no NAME=COUNT");
    expect[part.substr(0, equals)] = number(part.substr(equals + 1));
  }
  return expect;
}

std::vector<std::string> missing(const Expectation& expect, const std::string& service,
                                 const std::vector<Peer>& peers, const std::string& action) {
  std::vector<std::string> names;
  const auto expected = expect.find(service);
  if (expected == expect.end()) return names;
  for (std::uint32_t i = 0; i < expected->second; ++i) {
    if (std::find(peers.begin(), peers.end(), Peer{service, i}) != peers.end()) continue;
    names.push_back(service + "/" + std::to_string(i) + " " + action);
  }
  return names;
}

}  // namespace scarab::fastdds
