#include "common/bus/peer.hpp"

#include <charconv>
#include <system_error>

namespace scarab::bus {

namespace {
constexpr std::string_view kPrefix = "scarab:";
}

std::string to_string(const Peer& peer) {
  return peer.service.empty() ? "foreign" : peer.service + "/" + std::to_string(peer.instance);
}

std::string encode_peer(const Peer& self) {
  return std::string(kPrefix) + self.service + ":" + std::to_string(self.instance);
}

Peer decode_peer(std::string_view user_data) {
  if (user_data.substr(0, kPrefix.size()) != kPrefix) return {};
  user_data.remove_prefix(kPrefix.size());
  const std::size_t colon = user_data.rfind(':');
  if (colon == std::string_view::npos || colon == 0) return {};
  const std::string_view number = user_data.substr(colon + 1);
  Peer peer{std::string(user_data.substr(0, colon)), 0};
  const char* end = number.data() + number.size();
  const auto [stop, error] = std::from_chars(number.data(), end, peer.instance);
  if (error != std::errc{} || stop != end) return {};
  return peer;
}

}  // namespace scarab::bus
