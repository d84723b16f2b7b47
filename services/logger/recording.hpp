#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "common/mcap/writer.hpp"
#include "services/logger/batch_queue.hpp"
#include "services/logger/core/recorded_progress.hpp"

namespace scarab::logger {

/// What the writer thread has done so far.
struct RecordingState {
  RecordedProgress progress;
  std::uint64_t messages = 0;
  std::uint64_t bytes = 0;  ///< of samples, before compression
  std::uint32_t channels = 0;
};

/// Writes batches into an MCAP file on a thread of its own, so that neither compression nor the
/// disk ever holds up the thread that takes samples from the bus.
class Recording {
 public:
  /// `notify` is called from the writer thread after each batch that moved the progress on, and
  /// when writing failed.
  Recording(std::unique_ptr<mcap::Writer> writer, std::size_t queue_limit_bytes,
            std::function<void()> notify);
  /// Without close() before it: stops at once; the file stays `.active`.
  ~Recording();
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  /// Hands a batch over; waits while the writer thread is too far behind. After a failure the batch
  /// is dropped.
  void push(SampleBatch&& batch) { queue_.push(std::move(batch)); }
  RecordingState state() const;
  /// True once writing has failed; close() throws what happened.
  bool failed() const;
  /// Writes everything handed over, then `final_metadata` of the last state, closes the file.
  /// Throws what made the writing fail (mcap::FileError).
  void close(const std::function<mcap::Metadata(const RecordingState&)>& final_metadata);

 private:
  void run();
  void write(const SampleBatch& batch);
  void add_channel(const ChannelSpec& spec);
  void stop();

  std::unique_ptr<mcap::Writer> writer_;  // used by the thread alone until it has ended
  BatchQueue queue_;
  std::function<void()> notify_;
  struct RecordedChannel {
    std::uint16_t id = 0;
    bool shows_progress = false;
  };
  std::vector<RecordedChannel> channels_;
  std::map<std::string, std::uint16_t> schema_ids_;  // by IDL text

  mutable std::mutex mutex_;  // of the two below
  RecordingState state_;
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace scarab::logger
