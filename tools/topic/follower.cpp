#include "tools/topic/follower.hpp"

#include <algorithm>
#include <iostream>

#include "common/bus/raw_qos.hpp"
#include "common/bus/topic_type.hpp"
#include "common/sample/idl_text.hpp"
#include "tools/topic/failure.hpp"

namespace scarab::topic {

namespace {

using bus::DiscoveredEndpoint;

constexpr std::chrono::milliseconds kTypePatience{500};

/// What one reader's QoS depends on.
std::string qos_key(const DiscoveredEndpoint& writer) {
  bus::RawQos qos = bus::raw_qos_of(*writer.qos);
  qos.ownership_strength = 0;
  std::string key;
  for (const auto& [word, value] : bus::to_words(qos)) key += word + "=" + value + "\n";
  return key;
}

}  // namespace

FollowedType::FollowedType(const bus::TopicType& described) : descriptor(described) {
  try {
    model = bus::model_of(*described);
    text = sample::idl_text(*model);
  } catch (const bus::Error& error) {
    text = error.what();
  }
}

Follower::Follower(Session& session, const std::string& topic, Clock::time_point end,
                   const bus::RawReaderOptions& options)
    : session_(session),
      topic_(topic),
      options_(options),
      type_(session.type_of(session.wait_for_writers(topic, end))) {
  follow_new_writers();
}

const sample::TypeModel& Follower::model() const {
  if (!type_.model) throw Failure(kExitNoType, topic_ + ": " + type_.text);
  return *type_.model;
}

void Follower::follow_new_writers() {
  if (arrivals_ == session_.arrivals()) return;
  arrivals_ = session_.arrivals();
  const DomainView view = session_.view();
  const auto writers = view.of_topic(topic_, bus::EndpointKind::kWriter);
  forget_all_but(writers);
  for (const DiscoveredEndpoint& writer : writers) {
    if (!seen_.insert(writer.guid).second) continue;
    try {
      follow(writer);
    } catch (const bus::Error& error) {
      std::cerr << "scarab-topic: cannot follow " << view.name_of(writer) << ": " << error.what()
                << std::endl;
    }
  }
}

void Follower::forget_all_but(const std::vector<DiscoveredEndpoint>& writers) {
  std::set<bus::Guid> alive;
  for (const DiscoveredEndpoint& writer : writers) {
    if (followed_.count(writer.guid) != 0) alive.insert(writer.guid);
  }
  followed_ = std::move(alive);
}

void Follower::follow(const DiscoveredEndpoint& writer) {
  FollowedType type(session_.discovery().type_of(writer, kTypePatience));
  if (type.text != type_.text) {
    if (!followed_.empty()) throw bus::Error("its type is another one");
    // Nobody writes the old one any more: a program has been restarted in a new version.
    readers_.clear();
    reader_of_qos_.clear();
    type_ = std::move(type);
    ++type_changes_;
  }
  followed_.insert(writer.guid);
  const auto [entry, fresh] = reader_of_qos_.try_emplace(qos_key(writer), readers_.size());
  if (!fresh) return;
  readers_.push_back(std::make_unique<bus::RawReader>(
      session_.participant(), std::vector<DiscoveredEndpoint>{writer}, type_.descriptor, options_));
  session_.waitset().attach(*readers_.back());
}

std::size_t Follower::take(Clock::time_point end, const SampleHandler& f) {
  // However fast they come: Ctrl-C, the clock and new writers get their turn.
  constexpr std::size_t kEnough = 1024;
  session_.wait(end);
  follow_new_writers();
  std::size_t count = 0;
  for (std::size_t i = 0; i < readers_.size(); ++i) {
    const auto once = [&](const bus::RawSample& sample) {
      if (reader_of_writer_.try_emplace(sample.writer, i).first->second != i) return;
      f(sample);
      ++count;
    };
    readers_[i]->take(once, kEnough);
  }
  return count;
}

}  // namespace scarab::topic
