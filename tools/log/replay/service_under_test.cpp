#include "tools/log/replay/service_under_test.hpp"

#include <charconv>
#include <map>
#include <stdexcept>

namespace scarab::log {
namespace {

/// `plant/0`; foreign for other text.
bus::Peer peer_of(const std::string& text) {
  const std::size_t slash = text.rfind('/');
  if (slash == std::string::npos || slash == 0) return {};
  bus::Peer peer{text.substr(0, slash), 0};
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data() + slash + 1, last, peer.instance);
  return error == std::errc() && end == last ? peer : bus::Peer{};
}

}  // namespace

ServiceUnderTest service_under_test(const std::string& name, std::uint32_t instance) {
  if (name == "supervisor") {
    return {{name, instance}, "scarab/robot_state", "scarab/behaviour", ""};
  }
  if (name == "premotor") {
    return {{name, instance}, "scarab/behaviour", "scarab/joint_command", "scarab/neural_activity"};
  }
  throw std::invalid_argument("--against " + name + ": there are supervisor and premotor");
}

bus::Peer writer_of(const LogChannel& channel) {
  static const std::map<std::string, std::string> kWriters = {
      {"scarab/trial", "experiment"},
      {"scarab/operator", "operator"},
      {"scarab/behaviour", "supervisor"},
      {"scarab/joint_command", "premotor"},
      {"scarab/neural_activity", "premotor"}};
  const auto recorded = channel.record.metadata.find("writers");
  if (recorded != channel.record.metadata.end()) {
    const bus::Peer peer = peer_of(recorded->second.substr(0, recorded->second.find(' ')));
    if (!peer.service.empty()) return peer;
  }
  const auto usual = kWriters.find(channel.topic);
  return {usual == kWriters.end() ? "plant" : usual->second, 0};
}

std::string short_name(const std::string& topic) {
  const std::size_t slash = topic.rfind('/');
  return slash == std::string::npos ? topic : topic.substr(slash + 1);
}

}  // namespace scarab::log
