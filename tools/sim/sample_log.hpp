#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "common/bus/cdr.hpp"
#include "common/bus/clock.hpp"
#include "common/bus/topics.hpp"
#include "common/mcap/writer.hpp"

namespace scarab::sim {

/// Records samples without a bus: the same encoding, schemas and file as the logger's. Without a
/// path it records nothing.
class SampleLog {
 public:
  explicit SampleLog(const std::filesystem::path& path);

  template <class T>
  void write(const bus::Topic<T>& topic, const T& sample) {
    if (writer_) write_bytes(topic.name, bus::descriptor<T>(), bus::encode(sample));
  }
  /// Finishes the file. Without it the file stays `.active`.
  void close();

 private:
  void write_bytes(const std::string& topic, const dds_topic_descriptor_t& type,
                   const sample::Bytes& bytes);
  std::uint16_t add_channel(const std::string& topic, const dds_topic_descriptor_t& type);

  struct Channel {
    std::uint16_t id = 0;
    std::uint32_t sequence = 0;
  };
  std::unique_ptr<mcap::Writer> writer_;
  std::map<std::string, Channel> channels_;
};

}  // namespace scarab::sim
