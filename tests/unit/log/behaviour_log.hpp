#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "common/bus/cdr.hpp"
#include "common/bus/sample_fields.hpp"
#include "common/bus/topic_type.hpp"
#include "common/bus/topics.hpp"
#include "common/mcap/writer.hpp"
#include "common/sample/idl_text.hpp"

namespace scarab::log::test {

inline constexpr std::uint64_t kSecond = 1'000'000'000;

/// Writes samples of the project's topics, and messages of other channels, into a log.
class LogWriter {
 public:
  explicit LogWriter(const std::filesystem::path& path, const mcap::WriterOptions& options = {})
      : writer_(path, options) {}

  template <class T>
  void write(const bus::Topic<T>& topic, const T& sample, std::uint64_t time_ns) {
    const sample::Bytes bytes = bus::encode(sample);
    write(channel_of(topic), time_ns, {bytes.data(), bytes.size()});
  }
  /// The bytes of a sample, published and recorded at a time.
  template <class T>
  void write_at(const bus::Topic<T>& topic, std::uint64_t time_ns, mcap::ByteView bytes) {
    writer_.write({channel_of(topic), sequence_++, time_ns, time_ns, bytes});
  }
  /// The n-th message, n seconds after the epoch.
  void write(const scarab_Behaviour& behaviour) {
    write(bus::kBehaviour, behaviour, kSecond * sequence_);
  }
  /// A channel of any kind.
  std::uint16_t add_channel(const std::string& topic, const std::string& type,
                            const std::string& encoding, const std::string& schema) {
    return writer_.add_channel(writer_.add_schema(type, encoding, schema), topic, "cdr");
  }
  void write(std::uint16_t channel, std::uint64_t publish_time_ns, mcap::ByteView bytes) {
    writer_.write({channel, sequence_, kSecond * (sequence_ + 1), publish_time_ns, bytes});
    ++sequence_;
  }
  /// The next message is so many seconds later.
  void skip(std::uint32_t seconds) { sequence_ += seconds; }
  mcap::Writer& writer() { return writer_; }
  void close() { writer_.close(); }

 private:
  template <class T>
  std::uint16_t channel_of(const bus::Topic<T>& topic) {
    const auto found = channels_.find(topic.name);
    if (found != channels_.end()) return found->second;
    const auto type = bus::model_of(bus::descriptor<T>());
    const auto channel = add_channel(topic.name, type.name(), "omgidl", sample::idl_text(type));
    channels_[topic.name] = channel;
    return channel;
  }

  mcap::Writer writer_;
  std::map<std::string, std::uint16_t> channels_;
  std::uint32_t sequence_ = 0;
};

inline scarab_Behaviour behaviour(std::uint32_t trial, std::uint32_t tick, std::int64_t stamp) {
  scarab_Behaviour b{};
  b.header = {trial, tick, tick * 100'000'000LL, stamp};
  b.mode = scarab_MODE_BACKWARD;
  bus::assign(b.reason, "walks, \"slowly\"");
  return b;
}

/// A type that is none of the project's, and a sample of it.
inline constexpr const char* kMeadowIdl =
    "module meadow {\n"
    "  enum Kind { GRASS, CLOVER };\n"
    "  @final struct Patch { double area_m2; sequence<unsigned short> flowers; Kind kind; };\n"
    "};\n";
inline std::vector<std::uint8_t> patch(double area_m2, std::vector<std::uint16_t> flowers) {
  std::vector<std::uint8_t> bytes = {0, 1, 0, 0};
  const auto append = [&](auto value) {
    const auto* from = reinterpret_cast<const std::uint8_t*>(&value);
    bytes.insert(bytes.end(), from, from + sizeof(value));
  };
  append(area_m2);
  append(static_cast<std::uint32_t>(flowers.size()));
  for (const std::uint16_t flower : flowers) append(flower);
  if (flowers.size() % 2 != 0) append(std::uint16_t{0});  // the enum begins at a multiple of 4
  append(std::uint32_t{1});
  return bytes;
}

}  // namespace scarab::log::test
