#include "common/runtime/peers.hpp"

#include <algorithm>

namespace scarab::runtime {

void PeerCheck::need(const bus::WriterEndpoint& writer, const std::string& service) {
  needs_.push_back({service, "to read " + writer.topic(), [&writer] { return writer.matched(); },
                    [&writer] { return writer.faults(); }, false});
}

void PeerCheck::need(const bus::ReaderEndpoint& reader, const std::string& service) {
  needs_.push_back({service, "to write " + reader.topic(), [&reader] { return reader.matched(); },
                    [&reader] { return reader.faults(); }, true});
}

std::vector<std::string> PeerCheck::unmet() const {
  std::vector<std::string> unmet;
  for (const auto& need : needs_) check(need, unmet);
  return unmet;
}

void PeerCheck::check(const Need& need, std::vector<std::string>& unmet) const {
  const auto expected = expect_.find(need.service);
  if (expected == expect_.end()) return;
  const std::vector<bus::Peer> peers = need.matched();
  const auto of_service = std::count_if(peers.begin(), peers.end(), [&](const bus::Peer& peer) {
    return peer.service == need.service;
  });
  const std::size_t before = unmet.size();
  for (std::uint32_t instance = 0; instance < expected->second; ++instance) {
    const bus::Peer wanted{need.service, instance};
    if (std::find(peers.begin(), peers.end(), wanted) == peers.end()) {
      unmet.push_back(need.service + "/" + std::to_string(instance) + " " + need.action);
    }
  }
  const bool incomplete = unmet.size() > before;
  if (incomplete) {
    for (auto& fault : need.faults()) unmet.push_back(std::move(fault));
  }
  if (need.limited && of_service > static_cast<std::ptrdiff_t>(expected->second)) {
    unmet.push_back("only " + std::to_string(expected->second) + " " + need.service + " " +
                    need.action + " (found " + std::to_string(of_service) + ")");
  }
}

std::string join(const std::vector<std::string>& phrases) {
  std::string text;
  for (std::size_t i = 0; i < phrases.size(); ++i) {
    if (i > 0) text += i + 1 == phrases.size() ? " and " : ", ";
    text += phrases[i];
  }
  return text;
}

}  // namespace scarab::runtime
