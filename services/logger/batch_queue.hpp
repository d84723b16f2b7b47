#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>

#include "services/logger/sample_batch.hpp"

namespace scarab::logger {

/// Batches between the thread that takes from the bus and the one that writes the file. Bounded by
/// who puts in: while it is full, that one waits for room, or drops the samples of its batch.
class BatchQueue {
 public:
  explicit BatchQueue(std::size_t limit_bytes) : limit_bytes_(limit_bytes) {}

  /// Never waits. A batch without samples costs nothing: it joins one that is in already. False,
  /// and the batch is gone, when the queue was closed.
  bool push(SampleBatch&& batch);
  /// Its batches have reached the limit; what is pushed now is beyond it.
  bool full() const;
  /// False: still full after `timeout`. A closed queue is never full.
  bool wait_for_room(std::chrono::nanoseconds timeout);
  /// The next batch; nothing after `timeout`, or when the queue is closed and empty.
  std::optional<SampleBatch> pop(std::chrono::nanoseconds timeout);
  /// Bytes of the batches inside.
  std::size_t size_bytes() const;
  /// Nothing more goes in; what is inside can still be taken out.
  void close();
  /// False: still open after `timeout`.
  bool wait_for_close(std::chrono::nanoseconds timeout);
  /// True when it is closed and empty.
  bool finished() const;

 private:
  bool is_full() const { return !closed_ && size_bytes_ >= limit_bytes_; }

  std::size_t limit_bytes_;
  mutable std::mutex mutex_;
  std::condition_variable has_room_;
  std::condition_variable has_batch_;
  std::condition_variable closed_now_;
  std::deque<SampleBatch> batches_;
  std::size_t size_bytes_ = 0;
  bool closed_ = false;
};

}  // namespace scarab::logger
