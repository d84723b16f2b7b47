#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/bus/error.hpp"
#include "common/bus/raw_cdr.hpp"
#include "common/mcap/reader.hpp"
#include "common/sample/type_model.hpp"

namespace scarab::log {

/// A channel of one file, and how its messages are read.
struct LogChannel {
  std::string topic;
  std::string type_name;                  ///< as its schema says; empty without one
  std::optional<sample::TypeModel> type;  ///< none: messages are bytes
  std::string no_type;                    ///< why there is none, in words
  bool has_header = false;                ///< messages begin with the chain's Header
  mcap::Channel record;
};

/// One file, or several that are parts of one recording, read as one log: file after file in the
/// order of their first messages.
class Log {
 public:
  /// Files, or directories whose logs (*.mcap, and *.mcap.active while they are written or after a
  /// kill) are meant. A cut file beside the one that `recover` has made of it is passed over.
  /// Throws std::invalid_argument for a path with no log in it; as mcap::Reader.
  explicit Log(const std::vector<std::filesystem::path>& paths, const mcap::Progress& = {});
  explicit Log(const std::filesystem::path& path) : Log(std::vector{path}) {}

  const std::vector<std::unique_ptr<mcap::Reader>>& files() const { return files_; }
  /// Those of which another file has everything.
  const std::vector<std::filesystem::path>& passed_over() const { return passed_over_; }
  /// The path that was given, or the first of several.
  const std::filesystem::path& name() const { return name_; }

  /// The topics there are, by name.
  std::set<std::string> topics() const;
  /// A channel of the topic: the first one whose type is known, if any is; null: no such topic.
  const LogChannel* find(const std::string& topic) const;
  /// Its channels: one a file, or more where its type or its writers differ.
  std::vector<const LogChannel*> channels(const std::string& topic) const;
  /// Messages of a topic; of all topics.
  std::uint64_t count(const std::string& topic) const;
  std::uint64_t count() const;

  /// True: go on.
  using Visitor = std::function<bool(const LogChannel&, const mcap::Message&)>;
  /// Visits the messages of `topics` (none: of all) in the order of the log, up to where `visit`
  /// says false. Throws as mcap::Reader.
  void for_each(const Visitor& visit, const std::set<std::string>& topics = {}) const;

 private:
  void pass_over_mended();
  void add_channels(const mcap::Reader& file);

  std::filesystem::path name_;
  std::vector<std::unique_ptr<mcap::Reader>> files_;
  std::vector<std::filesystem::path> passed_over_;
  std::vector<std::map<std::uint16_t, LogChannel>> channels_;  ///< beside files_
};

/// A message's bytes as the bus takes them.
inline sample::ByteView cdr_of(const mcap::Message& message) {
  return {reinterpret_cast<const std::byte*>(message.data.data()), message.data.size()};
}

/// Calls f, which reads a message; a bus::Error it throws names topic and message then.
template <class F>
void read_message(const LogChannel& channel, const mcap::Message& message, F&& f) {
  try {
    f();
  } catch (const bus::Error& error) {
    throw bus::Error(channel.topic + ", message " + std::to_string(message.sequence) + ": " +
                     error.what());
  }
}

/// Throws std::invalid_argument, naming the topics there are, for one that the log does not have.
const LogChannel& require_topic(const Log& log, const std::string& topic);

/// The same, and the type of its samples. Throws std::invalid_argument where it is not known, or
/// not the same for all.
const sample::TypeModel& require_type(const Log& log, const std::string& topic);

}  // namespace scarab::log
