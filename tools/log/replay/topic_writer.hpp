#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "common/bus/raw_writer.hpp"
#include "tools/log/log.hpp"

namespace scarab::log {

/// The QoS that a channel's topic was written with; for logs that do not say so, the policies that
/// every reader of the project's topics matches, and for other topics those of most.
bus::RawQos recorded_qos(const LogChannel& channel);

/// Publishes the messages of a channel as its writers did: with their type, which is in the log,
/// and their QoS, but for the history.
class TopicWriter {
 public:
  /// Throws bus::Error saying why the channel cannot be published.
  TopicWriter(bus::Participant& participant, const LogChannel& channel);

  const std::string& topic() const { return writer_.topic(); }
  std::vector<bus::Peer> matched() const { return writer_.matched(); }

  /// Publishes, stamped with `source_ns` or the time of the call. Waits for reliable readers that
  /// cannot follow; throws bus::Error where they do not for a second.
  void write(const mcap::Bytes& cdr, std::optional<std::int64_t> source_ns = std::nullopt);
  /// Waits until all reliable readers have everything; false after `limit`.
  bool flush(std::chrono::nanoseconds limit) { return writer_.await_acknowledged(limit); }

 private:
  bus::RawWriter writer_;
};

}  // namespace scarab::log
