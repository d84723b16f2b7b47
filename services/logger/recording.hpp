#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "services/logger/batch_queue.hpp"
#include "services/logger/log_series.hpp"

namespace scarab::logger {

/// Writes batches into a series of MCAP files on a thread of its own, so that neither compression
/// nor the disk ever holds up the thread that takes samples from the bus.
class Recording {
 public:
  /// `notify` is called from the writer thread after each batch that moved the progress on, and
  /// when writing failed, was held up, or goes on.
  Recording(std::unique_ptr<LogSeries> series, std::size_t queue_limit_bytes,
            std::function<void()> notify);
  /// Without close() before it: stops at once; the file stays `.active`.
  ~Recording();
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  /// Hands a batch over, whether there is room or not: ask first. After a failure it is dropped.
  void push(SampleBatch&& batch) { queue_.push(std::move(batch)); }
  /// The writer thread is too far behind: what waits for it has reached the limit.
  bool full() const { return queue_.full(); }
  /// Bytes of samples that wait for it.
  std::size_t queued_bytes() const { return queue_.size_bytes(); }
  /// False: still full after `timeout`.
  bool wait_for_room(std::chrono::nanoseconds timeout) { return queue_.wait_for_room(timeout); }
  /// What is in the files, and in the open chunk.
  RecordingState state() const;
  /// Why nothing is written for the time being; empty while all is well.
  std::string obstacle() const;
  /// True once writing has failed; close() throws what happened.
  bool failed() const;
  /// Writes everything handed over and closes the file. Throws what made the writing fail
  /// (mcap::FileError).
  void close();

 private:
  void run();
  bool hold_while_no_room();
  void tell_obstacle(const std::string& obstacle);
  void write(const SampleBatch& batch);
  void stop();

  std::unique_ptr<LogSeries> series_;  // used by the thread alone until it has ended
  BatchQueue queue_;
  std::function<void()> notify_;

  mutable std::mutex mutex_;  // of the three below
  RecordingState state_;
  std::string obstacle_;
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace scarab::logger
