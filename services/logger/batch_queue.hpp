#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>

#include "services/logger/sample_batch.hpp"

namespace scarab::logger {

/// Batches between the thread that takes from the bus and the one that writes the file. Bounded:
/// who puts in waits while it is full, and the bus's own queues hold what comes meanwhile.
class BatchQueue {
 public:
  explicit BatchQueue(std::size_t limit_bytes) : limit_bytes_(limit_bytes) {}

  /// Waits for room (one batch always fits). False, and the batch is gone, when the queue was
  /// closed.
  bool push(SampleBatch&& batch);
  /// The next batch; nothing after `timeout`, or when the queue is closed and empty.
  std::optional<SampleBatch> pop(std::chrono::nanoseconds timeout);
  /// Nothing more goes in; what is inside can still be taken out.
  void close();
  /// True when it is closed and empty.
  bool finished() const;

 private:
  std::size_t limit_bytes_;
  mutable std::mutex mutex_;
  std::condition_variable has_room_;
  std::condition_variable has_batch_;
  std::deque<SampleBatch> batches_;
  std::size_t size_bytes_ = 0;
  bool closed_ = false;
};

}  // namespace scarab::logger
