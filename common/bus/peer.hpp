#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace scarab::bus {

/// Who stands behind an endpoint: the service's name and instance number. Every endpoint of the
/// project carries it as its user data, `scarab:<service>:<instance>`.
struct Peer {
  std::string service;  ///< empty for a foreign endpoint, one without such user data
  std::uint32_t instance = 0;
};

inline bool operator==(const Peer& a, const Peer& b) {
  return a.service == b.service && a.instance == b.instance;
}
inline bool operator!=(const Peer& a, const Peer& b) { return !(a == b); }
inline bool operator<(const Peer& a, const Peer& b) {
  return a.service != b.service ? a.service < b.service : a.instance < b.instance;
}

/// `service/instance`, or `foreign` for an endpoint that does not say who it is.
std::string to_string(const Peer& peer);

/// The user data of an endpoint of `self`.
std::string encode_peer(const Peer& self);

/// The peer of an endpoint's user data; a foreign one when the text has another form.
Peer decode_peer(std::string_view user_data);

}  // namespace scarab::bus
