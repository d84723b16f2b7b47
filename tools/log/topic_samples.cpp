#include "tools/log/topic_samples.hpp"

#include <algorithm>

#include "common/sample/sample_json.hpp"

namespace scarab::log {
namespace {

logger::SampleHeader header_of(const LogChannel& channel, const mcap::Message& message) {
  if (!channel.has_header) return {};
  const auto header = logger::read_sample_header(message.data.data(), message.data.size());
  if (!header) {
    throw mcap::FormatError(channel.topic + ": a sample of " + std::to_string(message.data.size()) +
                            " bytes does not begin with a header");
  }
  return *header;
}

std::vector<sample::FieldPath> key_of(const LogChannel& channel) {
  std::vector<sample::FieldPath> key;
  if (!channel.type) return key;
  for (const sample::Member& member : channel.type->root().members) {
    if (member.key) key.emplace_back(*channel.type, member.name);
  }
  return key;
}

void put_in_order(std::vector<Sample>& samples, bool have_header) {
  std::stable_sort(samples.begin(), samples.end(), [&](const Sample& a, const Sample& b) {
    return have_header ? place_of(a) < place_of(b) : a.publish_time_ns < b.publish_time_ns;
  });
  if (!have_header) return;
  const auto repeats = [](const Sample& a, const Sample& b) {
    return place_of(a) == place_of(b) && equal_bytes(a.cdr, b.cdr, true);
  };
  samples.erase(std::unique(samples.begin(), samples.end(), repeats), samples.end());
}

}  // namespace

bool equal_bytes(mcap::ByteView a, mcap::ByteView b, bool have_header) {
  if (a.size() != b.size()) return false;
  if (!have_header || a.size() < logger::kStampEnd)
    return std::equal(a.begin(), a.end(), b.begin());
  return std::equal(a.begin(), a.begin() + logger::kStampBegin, b.begin()) &&
         std::equal(a.begin() + logger::kStampEnd, a.end(), b.begin() + logger::kStampEnd);
}

TopicSamples load_samples(const Log& log, const std::string& topic) {
  TopicSamples groups;
  std::map<const LogChannel*, std::vector<sample::FieldPath>> keys;
  for (const LogChannel* channel : log.channels(topic)) keys[channel] = key_of(*channel);
  bool have_header = false;
  log.for_each(
      [&](const LogChannel& channel, const mcap::Message& message) {
        const auto header = header_of(channel, message);
        const auto& key = keys.at(&channel);
        std::string instance;
        if (!key.empty()) {
          append_fields(instance, key, sample::sample_tree(*channel.type, cdr_of(message)));
        }
        have_header = channel.has_header;
        groups[{header.trial, instance}].push_back(
            {header, message.publish_time_ns, mcap::copy_of(message.data)});
        return true;
      },
      {topic});
  for (auto& [group, samples] : groups) put_in_order(samples, have_header);
  return groups;
}

}  // namespace scarab::log
