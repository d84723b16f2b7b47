#include "services/logger/topic_recorder.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <set>
#include <utility>

#include "common/bus/delivery_loss.hpp"
#include "common/bus/error.hpp"
#include "services/logger/channel_facts.hpp"

namespace scarab::logger {
namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

TopicRecorder::TopicRecorder(bus::Participant& participant, bus::WaitSet& wait_set)
    : participant_(participant), wait_set_(wait_set), discovery_(participant) {
  wait_set_.attach(discovery_);
}

void TopicRecorder::discover(SampleBatch& batch) {
  const bool news = !discovery_.update().empty();
  const auto now = Clock::now();
  const bool retry = std::any_of(unknown_.begin(), unknown_.end(),
                                 [&](const auto& entry) { return now >= entry.second.try_again; });
  if (!news && !retry) return;
  for (const bus::DiscoveredEndpoint& endpoint : discovery_.endpoints()) {
    const auto known = unknown_.find(endpoint.topic);
    const bool wait = known != unknown_.end() && now < known->second.try_again;
    if (endpoint.kind == bus::EndpointKind::kWriter && topics_.count(endpoint.topic) == 0 &&
        !wait) {
      add_topic(endpoint, batch);
    }
  }
}

void TopicRecorder::add_topic(const bus::DiscoveredEndpoint& writer, SampleBatch& batch) {
  // The writer's process answers within milliseconds, or not at all.
  constexpr std::chrono::milliseconds kTypeTimeout{500};
  constexpr std::chrono::seconds kRetry{2};
  try {
    const bus::TopicType type = discovery_.type_of(writer, kTypeTimeout);
    std::vector<bus::DiscoveredEndpoint> writers = discovery_.endpoints();
    writers.erase(std::remove_if(writers.begin(), writers.end(),
                                 [&](const bus::DiscoveredEndpoint& other) {
                                   return other.kind != bus::EndpointKind::kWriter ||
                                          other.topic != writer.topic;
                                 }),
                  writers.end());
    Topic topic;
    topic.reader = std::make_unique<bus::RawReader>(participant_, writers, type);
    topic.channel = static_cast<std::uint32_t>(topics_.size());
    batch.add_channel(describe_channel(writers, type));
    wait_set_.attach(*topic.reader);
    topics_.emplace(writer.topic, std::move(topic));
    newest_reader_ = Clock::now();
    unknown_.erase(writer.topic);
    spdlog::info("records {} ({})", writer.topic, writer.type);
  } catch (const bus::Error& error) {
    if (unknown_.count(writer.topic) == 0) {
      spdlog::warn("cannot record {}: {}", writer.topic, error.what());
    }
    unknown_[writer.topic] = {error.what(), Clock::now() + kRetry};
  }
}

void TopicRecorder::take_from(Topic& topic, SampleBatch& batch) {
  topic.reader->take([&](const bus::RawSample& sample) {
    SampleBatch::Entry entry;
    entry.channel = topic.channel;
    entry.sequence = topic.next_sequence++;
    entry.log_time_ns = static_cast<std::uint64_t>(sample.reception_ns);
    entry.publish_time_ns = static_cast<std::uint64_t>(sample.source_ns);
    batch.add(entry, {sample.cdr.data, sample.cdr.size});
  });
}

SampleBatch TopicRecorder::take() {
  SampleBatch batch;
  discover(batch);
  for (auto& [name, topic] : topics_) {
    take_from(topic, batch);
  }
  return batch;
}

bool TopicRecorder::has_settled(const std::string& topic, const bus::Peer& peer) {
  const auto now = Clock::now();
  const auto since = matched_since_.try_emplace({topic, peer}, now).first->second;
  return now - std::max(since, newest_reader_) >= kHandshake;
}

std::vector<std::string> TopicRecorder::missing(const std::vector<ChainWriter>& needed) {
  std::vector<std::string> missing;
  for (const ChainWriter& need : needed) {
    const auto topic = topics_.find(need.topic);
    std::set<bus::Peer> matched;
    if (topic != topics_.end()) {
      const auto peers = topic->second.reader->matched();
      matched.insert(peers.begin(), peers.end());
    }
    for (std::uint32_t instance = 0; instance < need.count; ++instance) {
      const bus::Peer peer{need.service, instance};
      if (matched.count(peer) == 0) matched_since_.erase({need.topic, peer});
      if (matched.count(peer) == 0 || !has_settled(need.topic, peer)) {
        missing.push_back(bus::to_string(peer) + " to write " + need.topic);
      }
    }
  }
  return missing;
}

SampleBatch TopicRecorder::losses() {
  SampleBatch batch;
  for (auto& [name, topic] : topics_) {
    const bus::DeliveryLoss loss = bus::delivery_loss(*topic.reader);
    const std::uint64_t known = std::exchange(topic.known_lost, loss.lost + loss.rejected);
    if (topic.known_lost > known) batch.add_loss(topic.channel, {0, topic.known_lost - known});
  }
  return batch;
}

std::vector<std::string> TopicRecorder::faults() const {
  std::vector<std::string> faults;
  for (const auto& [name, topic] : topics_) {
    const auto found = topic.reader->faults();
    faults.insert(faults.end(), found.begin(), found.end());
  }
  for (const auto& [name, unknown] : unknown_) {
    faults.push_back("cannot record " + name + ": " + unknown.reason);
  }
  return faults;
}

}  // namespace scarab::logger
