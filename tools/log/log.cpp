#include "tools/log/log.hpp"

#include <algorithm>
#include <stdexcept>

#include "common/sample/idl_text.hpp"
#include "tools/log/channel_type.hpp"
#include "tools/log/mended_copy.hpp"

namespace scarab::log {
namespace {

using Paths = std::vector<std::filesystem::path>;

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

bool is_log(const std::filesystem::path& path) {
  const std::string name = path.filename();
  return ends_with(name, ".mcap") || ends_with(name, ".mcap.active");
}

Paths files_of(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) return {path};
  Paths files;
  for (const auto& entry : std::filesystem::directory_iterator(path)) {
    if (entry.is_regular_file() && is_log(entry.path())) files.push_back(entry.path());
  }
  if (files.empty()) {
    throw std::invalid_argument("no log (*.mcap) in the directory " + path.string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Where a file stands among the others: those without a message come last.
std::uint64_t begin_of(const mcap::Reader& file) {
  const mcap::Statistics& counted = file.summary().statistics;
  return counted.message_count == 0 ? UINT64_MAX : counted.start_time_ns;
}

std::uint64_t count_of(const mcap::Reader& file, std::uint16_t channel) {
  const auto& counts = file.summary().statistics.channel_message_counts;
  const auto found = counts.find(channel);
  return found == counts.end() ? 0 : found->second;
}

}  // namespace

Log::Log(const Paths& paths, const mcap::Progress& progress) : name_(paths.at(0)) {
  for (const auto& path : paths) {
    for (const auto& file : files_of(path)) {
      files_.push_back(std::make_unique<mcap::Reader>(file, mcap::Access::kIndexed, progress));
    }
  }
  pass_over_mended();
  std::stable_sort(files_.begin(), files_.end(),
                   [](const auto& a, const auto& b) { return begin_of(*a) < begin_of(*b); });
  for (const auto& file : files_) add_channels(*file);
}

void Log::pass_over_mended() {
  for (const auto& file : files_) {
    const bool is_mended = std::any_of(files_.begin(), files_.end(), [&](const auto& other) {
      return is_mended_copy(*other, *file);
    });
    if (is_mended) passed_over_.push_back(file->path());
  }
  const auto is_passed_over = [this](const auto& file) {
    return std::find(passed_over_.begin(), passed_over_.end(), file->path()) != passed_over_.end();
  };
  files_.erase(std::remove_if(files_.begin(), files_.end(), is_passed_over), files_.end());
}

void Log::add_channels(const mcap::Reader& file) {
  std::map<std::uint16_t, LogChannel>& channels = channels_.emplace_back();
  for (const auto& [id, channel] : file.summary().channels) {
    const auto schema = file.summary().schemas.find(channel.schema_id);
    const bool has_schema = schema != file.summary().schemas.end();
    channels.emplace(id, read_channel(channel, has_schema ? &schema->second : nullptr));
  }
}

std::set<std::string> Log::topics() const {
  std::set<std::string> topics;
  for (const auto& channels : channels_) {
    for (const auto& [id, channel] : channels) topics.insert(channel.topic);
  }
  return topics;
}

std::vector<const LogChannel*> Log::channels(const std::string& topic) const {
  std::vector<const LogChannel*> found;
  for (const auto& channels : channels_) {
    for (const auto& [id, channel] : channels) {
      if (channel.topic == topic) found.push_back(&channel);
    }
  }
  return found;
}

const LogChannel* Log::find(const std::string& topic) const {
  const auto found = channels(topic);
  if (found.empty()) return nullptr;
  const auto typed = std::find_if(found.begin(), found.end(),
                                  [](const LogChannel* channel) { return bool(channel->type); });
  return typed == found.end() ? found.front() : *typed;
}

std::uint64_t Log::count(const std::string& topic) const {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < files_.size(); ++i) {
    for (const auto& [id, channel] : channels_[i]) {
      if (channel.topic == topic) count += count_of(*files_[i], id);
    }
  }
  return count;
}

std::uint64_t Log::count() const {
  std::uint64_t count = 0;
  for (const auto& file : files_) count += file->summary().statistics.message_count;
  return count;
}

void Log::for_each(const Visitor& visit, const std::set<std::string>& topics) const {
  for (std::size_t i = 0; i < files_.size(); ++i) {
    const auto& channels = channels_[i];
    const bool goes_on = files_[i]->for_each_while(
        [&](const mcap::Channel& channel, const mcap::Message& message) {
          return visit(channels.at(channel.id), message);
        },
        topics);
    if (!goes_on) return;
  }
}

const LogChannel& require_topic(const Log& log, const std::string& topic) {
  const LogChannel* channel = log.find(topic);
  if (channel != nullptr) return *channel;
  std::string known;
  for (const std::string& name : log.topics()) known += " " + name;
  throw std::invalid_argument("no topic " + topic + " in " + log.name().string() +
                              (known.empty() ? "; it has none" : "; there are" + known));
}

const sample::TypeModel& require_type(const Log& log, const std::string& topic) {
  const LogChannel& channel = require_topic(log, topic);
  if (!channel.type) throw std::invalid_argument(topic + ": " + channel.no_type);
  const std::string idl = sample::idl_text(*channel.type);
  for (const LogChannel* other : log.channels(topic)) {
    if (!other->type || sample::idl_text(*other->type) != idl) {
      throw std::invalid_argument(topic + " has samples of different types");
    }
  }
  return *channel.type;
}

}  // namespace scarab::log
