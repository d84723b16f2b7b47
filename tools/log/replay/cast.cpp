#include "tools/log/replay/cast.hpp"

#include <algorithm>
#include <set>

#include "common/bus/error.hpp"
#include "common/runtime/tick_masters.hpp"
#include "tools/log/replay/domain_check.hpp"

namespace scarab::log {
namespace {

constexpr const char* kUsualTickMaster = "plant";

/// The part that waits for the answers: the tick master's, who waits for them in a stack.
bus::Peer leading_part(const std::set<bus::Peer>& parts) {
  const auto leader = std::find_if(parts.begin(), parts.end(), runtime::is_tick_master);
  return leader == parts.end() ? bus::Peer{kUsualTickMaster, 0} : *leader;
}

std::set<bus::Peer> parts_to_play(const Log& log, const ServiceUnderTest& service,
                                  const runtime::Expectation& expect) {
  std::set<bus::Peer> parts;
  for (const auto& [name, count] : expect) {
    for (std::uint32_t instance = 0; instance < count; ++instance) parts.insert({name, instance});
  }
  if (expect.empty()) {
    parts = {{"supervisor", 0}, {"premotor", 0}, {"logger", 0}};
    for (const std::string& topic : log.topics()) parts.insert(writer_of(*log.find(topic)));
    if (std::none_of(parts.begin(), parts.end(), runtime::is_tick_master)) {
      parts.insert({kUsualTickMaster, 0});
    }
  }
  parts.erase(service.peer);
  return parts;
}

bool has(const std::vector<bus::Peer>& peers, const bus::Peer& peer) {
  return std::find(peers.begin(), peers.end(), peer) != peers.end();
}

}  // namespace

Cast::Cast(const Log& log, const std::set<std::string>& topics, const ServiceUnderTest& service,
           const runtime::Expectation& expect, const runtime::BusOptions& bus, bool force)
    : service_(service), bus_(bus) {
  const std::set<bus::Peer> parts = parts_to_play(log, service, expect);
  const bus::Peer leader = leading_part(parts);
  session_ = std::make_unique<Session>(bus.participant(leader.service, leader.instance));
  if (!force) refuse_company(session_->participant(), topics);
  discovery_ = std::make_unique<bus::Discovery>(session_->participant());
  readers_.push_back(read_answers(session_->participant(), service.answer));
  session_->wait_set().attach(readers_.front()->endpoint());
  if (!service.activity.empty()) {
    readers_.push_back(read_answers(session_->participant(), service.activity));
    activity_ = readers_.back().get();
    session_->wait_set().attach(activity_->endpoint());
  }
  for (const bus::Peer& part : parts) {
    if (part == leader) continue;
    bus::Participant& participant = participant_of(part);
    readers_.push_back(read_answers(participant, service.answer));
    if (!service.activity.empty()) {
      readers_.push_back(read_answers(participant, service.activity));
    }
  }
  for (const std::string& topic : topics) {
    for (const LogChannel* channel : log.channels(topic)) add_writer(*channel);
  }
}

bus::Participant& Cast::participant_of(const bus::Peer& peer) {
  if (peer == session_->participant().self()) return session_->participant();
  std::unique_ptr<bus::Participant>& participant = others_[peer];
  if (!participant) {
    participant = std::make_unique<bus::Participant>(bus_.participant(peer.service, peer.instance));
  }
  return *participant;
}

void Cast::add_writer(const LogChannel& channel) {
  for (const auto& [other, writer] : of_channel_) {
    // A part of a split log, or a replica: there is one writer of a topic.
    if (other->topic == channel.topic && other->type_name == channel.type_name) {
      of_channel_[&channel] = writer;
      return;
    }
  }
  try {
    writers_.push_back(std::make_unique<TopicWriter>(participant_of(writer_of(channel)), channel));
  } catch (const bus::Error& error) {
    left_out_.emplace_back(error.what());
    return;
  }
  of_channel_[&channel] = writers_.back().get();
}

TopicWriter* Cast::writer(const LogChannel& channel) {
  const auto found = of_channel_.find(&channel);
  return found == of_channel_.end() ? nullptr : found->second;
}

/// The service's readers of other topics than the question are known from their announcement alone.
std::vector<std::string> Cast::unmatched() {
  discovery_->update();
  std::set<std::string> read = {service_.question};
  for (const bus::DiscoveredEndpoint& endpoint : discovery_->endpoints()) {
    const bool reads = endpoint.kind == bus::EndpointKind::kReader;
    if (reads && endpoint.peer == service_.peer) read.insert(endpoint.topic);
  }
  std::vector<std::string> missing;
  const std::string name = bus::to_string(service_.peer);
  for (const auto& writer : writers_) {
    if (read.count(writer->topic()) != 0 && !has(writer->matched(), service_.peer)) {
      missing.push_back(name + " to read " + writer->topic());
    }
  }
  if (!has(readers_.front()->endpoint().matched(), service_.peer)) {
    missing.push_back(name + " to write " + service_.answer);
  }
  return missing;
}

bool Cast::flush(std::chrono::nanoseconds limit) {
  return std::all_of(writers_.begin(), writers_.end(),
                     [&](const auto& writer) { return writer->flush(limit); });
}

}  // namespace scarab::log
