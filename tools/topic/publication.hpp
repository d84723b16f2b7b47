#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

#include "common/bus/raw_writer.hpp"
#include "tools/topic/session.hpp"
#include "tools/topic/value_text.hpp"

namespace scarab::topic {

struct PublicationOptions {
  std::string topic;
  std::string type;         ///< by name; empty: that of the topic
  std::size_t readers = 1;  ///< to wait for
  std::chrono::milliseconds timeout{5000};
};

/// A writer of any topic, from written values.
class Publication {
 public:
  /// Finds out the type: the one named, that of the topic's endpoints, that of one of the project's
  /// own topics. Throws Failure (no such topic, type unknown) and Interrupted.
  Publication(Session& session, const PublicationOptions& options);

  /// The bytes of a value. Throws Failure (bad usage), naming `source`, for one that is none of the
  /// type.
  sample::Bytes encode(const std::string& source, const sample::WrittenValue& value) const;

  /// Makes the writer and waits until enough readers have matched. Throws Failure (timeout) saying
  /// who did not, and Interrupted.
  void open();

  void write(const sample::Bytes& sample);
  /// Waits until all readers have what was written. Throws Failure (timeout).
  void finish();

  std::vector<bus::Peer> readers() const { return writer_->matched(); }

 private:
  bus::TopicType find_type();

  Session& session_;
  PublicationOptions options_;
  Clock::time_point end_;  ///< of the waiting for the topic and its readers
  bus::TopicType type_;
  sample::TypeModel model_;
  std::optional<bus::RawWriter> writer_;
};

}  // namespace scarab::topic
