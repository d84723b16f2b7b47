#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "tools/log/log.hpp"

namespace scarab::log {

/// A message with the time at which it is to be published again.
struct TimedMessage {
  const LogChannel* channel = nullptr;
  std::uint64_t time_ns = 0;          ///< ns since the Unix epoch
  std::uint64_t publish_time_ns = 0;  ///< as recorded
  std::uint64_t position = 0;         ///< in the log, from 0
  mcap::Bytes cdr;
};

/// Puts the messages of a log in the order in which they were published, though a recorder writes
/// them down in the order in which it found them.
///
/// A message's time is that of its writer's clock, unless that is after it was recorded or more
/// than kWindow before: then (a late joiner was given an old sample, a host's clock is wrong) it is
/// the time of the recording. So no more than kWindow of the log is ever held.
class TimeOrder {
 public:
  static constexpr std::uint64_t kWindow = 1'000'000'000;  ///< ns

  /// Is told of the messages in order; false: enough.
  using Visitor = std::function<bool(TimedMessage&)>;
  explicit TimeOrder(Visitor visit) : visit_(std::move(visit)) {}

  /// The next message of the log. False: no more is wanted.
  bool push(const LogChannel& channel, const mcap::Message& message);
  /// The log is at its end: what is held follows. False: no more is wanted.
  bool flush();

 private:
  bool emit_until(std::uint64_t time_ns);

  Visitor visit_;
  std::vector<TimedMessage> held_;  ///< a heap, the next one first
  std::uint64_t newest_ns_ = 0;
  std::uint64_t next_position_ = 0;
};

/// When a message is to be published again; see TimeOrder.
std::uint64_t time_of(const mcap::Message& message);

}  // namespace scarab::log
