#include "common/config/json_object.hpp"
#include "tools/log/info.hpp"
#include "tools/log/words.hpp"

namespace scarab::log {
namespace {

constexpr const char* kMargin = "    ";

std::string json_of(const std::map<std::string, std::string>& entries) {
  config::JsonObject object;
  for (const auto& [key, value] : entries) object.text(key, value);
  return object.str();
}

std::string json_of(const FileFacts& file) {
  std::vector<std::string> attachments;
  for (const mcap::AttachmentIndex& attachment : file.attachments) {
    attachments.push_back(config::JsonObject()
                              .text("name", attachment.name)
                              .text("media_type", attachment.media_type)
                              .number("size", attachment.data_size)
                              .str());
  }
  std::vector<std::string> metadata;
  for (const mcap::Metadata& record : file.metadata) {
    metadata.push_back(config::JsonObject()
                           .text("name", record.name)
                           .raw("entries", json_of(record.entries))
                           .str());
  }
  std::vector<std::string> compressions;
  for (const std::string& name : file.compressions) {
    compressions.push_back(config::in_json_quotes(name));
  }
  return config::JsonObject()
      .text("path", file.path)
      .text("library", file.library)
      .text("profile", file.profile)
      .truth("closed", file.closed)
      .text("damage", file.damage)
      .number("bytes_lost", file.bytes_lost)
      .number("size", file.size)
      .number("chunks", file.chunks)
      .number("uncompressed_size", file.chunk_bytes)
      .raw("compressions", config::json_lines(compressions, "      "))
      .number("messages", file.messages)
      .text("start_ns", std::to_string(file.start_ns))
      .text("end_ns", std::to_string(file.end_ns))
      .raw("attachments", config::json_lines(attachments, "      "))
      .raw("metadata", config::json_lines(metadata, "      "))
      .str();
}

std::string json_of(const TopicFacts& topic) {
  return config::JsonObject()
      .text("topic", topic.topic)
      .text("type", topic.type)
      .text("no_type", topic.no_type)
      .number("messages", topic.messages)
      .raw("rate_hz", fixed_text(topic.rate_hz, 3))
      .text("writers", topic.writers)
      .raw("qos", json_of(topic.qos))
      .number("dropped", topic.dropped)
      .str();
}

std::string json_of(const TrialFacts& trial) {
  config::JsonObject object;
  object.number("trial", trial.trial)
      .text("strategy", trial.strategy)
      .number("ticks", trial.ticks)
      .number("first_tick", trial.first_tick)
      .number("last_tick", trial.last_tick)
      .raw("sim_time_s", fixed_text(trial.sim_time_s, 3));
  if (trial.real_time) object.text("pace", *trial.real_time ? "realtime" : "lockstep");
  return object.str();
}

template <class Facts>
std::string json_of(const std::vector<Facts>& all) {
  std::vector<std::string> values;
  for (const Facts& facts : all) values.push_back(json_of(facts));
  return config::json_lines(values, kMargin);
}

}  // namespace

void print_info_json(const LogFacts& facts, std::ostream& out) {
  out << "{\n  \"files\": " << json_of(facts.files) << ",\n  \"messages\": " << facts.messages
      << ",\n  \"dropped\": " << facts.dropped << ",\n  \"start_ns\": \"" << facts.start_ns
      << "\",\n  \"end_ns\": \"" << facts.end_ns << "\",\n  \"trials\": " << json_of(facts.trials)
      << ",\n  \"topics\": " << json_of(facts.topics) << "\n}\n";
}

}  // namespace scarab::log
