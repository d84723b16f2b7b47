#pragma once

#include <string>
#include <vector>

#include "common/mcap/reader.hpp"
#include "common/mcap/writer.hpp"

namespace scarab::mcap::test {

/// One message as a test compares it.
struct Logged {
  std::string topic;
  std::uint32_t sequence = 0;
  std::uint64_t log_time_ns = 0;
  std::uint64_t publish_time_ns = 0;
  Bytes data;
};

inline bool operator==(const Logged& a, const Logged& b) {
  return a.topic == b.topic && a.sequence == b.sequence && a.log_time_ns == b.log_time_ns &&
         a.publish_time_ns == b.publish_time_ns && a.data == b.data;
}

/// `count` messages in turn on topics a, b, c, 10 ms apart, with payloads of 0 to 36 bytes.
inline std::vector<Logged> make_messages(std::size_t count) {
  std::vector<Logged> messages;
  for (std::size_t i = 0; i < count; ++i) {
    Logged m;
    m.topic = std::string(1, static_cast<char>('a' + i % 3));
    m.sequence = static_cast<std::uint32_t>(i);
    m.log_time_ns = 1'700'000'000'000'000'000U + i * 10'000'000U;
    m.publish_time_ns = m.log_time_ns - 1000;
    m.data.assign(i % 37, static_cast<std::uint8_t>(i * 7));
    messages.push_back(std::move(m));
  }
  return messages;
}

/// Writes messages on three channels (a and b share a schema, c has none).
class SampleLog {
 public:
  SampleLog(const std::filesystem::path& path, const WriterOptions& options)
      : writer_(path, options) {
    const auto schema = writer_.add_schema("demo::Ab", "omgidl", "module demo { struct Ab {}; };");
    channels_["a"] = writer_.add_channel(schema, "a", "cdr", {{"kind", "first"}});
    channels_["b"] = writer_.add_channel(schema, "b", "cdr");
    channels_["c"] = writer_.add_channel(0, "c", "json");
  }

  void write(const std::vector<Logged>& messages) {
    for (const Logged& m : messages) {
      writer_.write({channels_.at(m.topic), m.sequence, m.log_time_ns, m.publish_time_ns, m.data});
    }
  }
  Writer& writer() { return writer_; }

 private:
  Writer writer_;
  std::map<std::string, std::uint16_t> channels_;
};

inline std::vector<Logged> read_messages(const Reader& reader,
                                         const std::set<std::string>& topics = {}) {
  std::vector<Logged> messages;
  reader.for_each(
      [&](const Channel& channel, const Message& m) {
        messages.push_back(
            {channel.topic, m.sequence, m.log_time_ns, m.publish_time_ns, copy_of(m.data)});
      },
      topics);
  return messages;
}

}  // namespace scarab::mcap::test
