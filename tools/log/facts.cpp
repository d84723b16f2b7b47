#include "tools/log/facts.hpp"

#include <algorithm>
#include <filesystem>

#include "common/sample/field_values.hpp"
#include "common/sample/sample_json.hpp"
#include "services/logger/core/sample_header.hpp"

namespace scarab::log {
namespace {

constexpr double kNsPerS = 1e9;
constexpr const char* kRecorded = "scarab.recorded";
constexpr const char* kDropped = "dropped";

FileFacts facts_of(const mcap::Reader& file) {
  const mcap::Summary& summary = file.summary();
  FileFacts facts;
  facts.path = file.path().string();
  facts.library = file.header().library;
  facts.profile = file.header().profile;
  facts.closed = file.closed();
  facts.damage = file.damage();
  facts.bytes_lost = file.bytes_lost();
  facts.size = std::filesystem::file_size(file.path());
  facts.chunks = summary.chunks.size();
  for (const mcap::ChunkIndex& chunk : summary.chunks) {
    facts.chunk_bytes += chunk.uncompressed_size;
    facts.compressions.insert(chunk.compression.empty() ? "none" : chunk.compression);
  }
  facts.messages = summary.statistics.message_count;
  facts.start_ns = summary.statistics.start_time_ns;
  facts.end_ns = summary.statistics.end_time_ns;
  facts.attachments = summary.attachments;
  for (const mcap::MetadataIndex& index : summary.metadata) {
    facts.metadata.push_back(file.metadata(index));
  }
  return facts;
}

/// A number the recorder has left when it closed the files; 0 where there is none.
std::uint64_t recorded_number(const std::vector<FileFacts>& files, const std::string& key) {
  std::uint64_t sum = 0;
  for (const FileFacts& file : files) {
    for (const mcap::Metadata& record : file.metadata) {
      const auto found = record.entries.find(key);
      if (record.name != kRecorded || found == record.entries.end()) continue;
      sum += std::strtoull(found->second.c_str(), nullptr, 10);
    }
  }
  return sum;
}

std::map<std::string, std::string> qos_words(const LogChannel& channel) {
  constexpr std::string_view kPrefix = "qos.";
  std::map<std::string, std::string> words;
  for (const auto& [key, value] : channel.record.metadata) {
    if (key.compare(0, kPrefix.size(), kPrefix) == 0) words[key.substr(kPrefix.size())] = value;
  }
  return words;
}

TopicFacts facts_of(const Log& log, const std::string& topic, const LogFacts& all) {
  const LogChannel& channel = *log.find(topic);
  TopicFacts facts;
  facts.topic = topic;
  facts.type = channel.type_name;
  facts.no_type = channel.no_type;
  facts.messages = log.count(topic);
  const double span_s = static_cast<double>(all.end_ns - all.start_ns) / kNsPerS;
  facts.rate_hz = span_s > 0 ? static_cast<double>(facts.messages) / span_s : 0;
  const auto writers = channel.record.metadata.find("writers");
  if (writers != channel.record.metadata.end()) facts.writers = writers->second;
  facts.qos = qos_words(channel);
  facts.dropped = recorded_number(all.files, std::string(kDropped) + "." + topic);
  return facts;
}

void add_span(LogFacts& facts) {
  for (const FileFacts& file : facts.files) {
    if (file.messages == 0) continue;
    const bool first = facts.messages == 0;
    facts.start_ns = first ? file.start_ns : std::min(facts.start_ns, file.start_ns);
    facts.end_ns = std::max(facts.end_ns, file.end_ns);
    facts.messages += file.messages;
  }
}

/// The one field of a message, as it stands in a table; nothing where its type has no such field.
std::optional<std::string> field_text(const LogChannel& channel, const mcap::Message& message,
                                      const std::string& field) try {
  if (!channel.type) return std::nullopt;
  const sample::FieldValues value(*channel.type, {sample::FieldPath(*channel.type, field)});
  std::string text;
  append_plain(text, value.read(cdr_of(message)).at(0).value());
  return text;
} catch (const bus::Error&) {
  return std::nullopt;
}

class Trials {
 public:
  void note(const LogChannel& channel, const mcap::Message& message) {
    const auto header = logger::read_sample_header(message.data.data(), message.data.size());
    if (!header) return;
    TrialFacts& facts = trials_[header->trial];
    facts.trial = header->trial;
    if (channel.topic == "scarab/trial") {
      facts.strategy = field_text(channel, message, "strategy").value_or("");
      return;
    }
    if (facts.ticks == 0) {
      const auto real_time = field_text(channel, message, "real_time");
      if (real_time) facts.real_time = *real_time == "true";
      facts.first_tick = header->tick;
    }
    ++facts.ticks;
    facts.last_tick = std::max(facts.last_tick, header->tick);
    facts.sim_time_s =
        std::max(facts.sim_time_s, static_cast<double>(header->sim_time_ns) / kNsPerS);
  }
  std::vector<TrialFacts> all() const {
    std::vector<TrialFacts> list;
    for (const auto& [number, facts] : trials_) list.push_back(facts);
    return list;
  }

 private:
  std::map<std::uint32_t, TrialFacts> trials_;
};

}  // namespace

LogFacts gather_facts(const Log& log, const mcap::Progress& progress) {
  LogFacts facts;
  for (const auto& file : log.files()) facts.files.push_back(facts_of(*file));
  add_span(facts);
  facts.dropped = recorded_number(facts.files, kDropped);
  for (const std::string& topic : log.topics()) {
    facts.topics.push_back(facts_of(log, topic, facts));
  }
  const std::set<std::string> read = {"scarab/robot_state", "scarab/trial"};
  std::uint64_t total = 0;
  for (const std::string& topic : read) total += log.count(topic);
  std::uint64_t done = 0;
  Trials trials;
  log.for_each(
      [&](const LogChannel& channel, const mcap::Message& message) {
        trials.note(channel, message);
        if (progress) progress(++done, total);
        return true;
      },
      read);
  facts.trials = trials.all();
  return facts;
}

}  // namespace scarab::log
