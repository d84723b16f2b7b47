#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/mcap/writer.hpp"
#include "services/logger/core/recorded_progress.hpp"
#include "services/logger/disk_space.hpp"
#include "services/logger/sample_batch.hpp"
#include "services/logger/trial_note.hpp"

namespace scarab::logger {

/// What a recording has done so far, over all of its files.
struct RecordingState {
  RecordedProgress progress;
  std::uint64_t messages = 0;
  std::uint64_t bytes = 0;  ///< of samples, before compression
  std::uint32_t channels = 0;
  std::uint32_t files = 0;
};

/// When a recording goes on in the next file. 0: never.
struct SeriesLimits {
  bool file_per_trial = false;
  std::uint64_t file_size_bytes = 0;
  std::chrono::nanoseconds file_time{0};  ///< of log time, from a file's first sample
};

/// Which file of a recording one is.
struct Part {
  std::uint32_t number = 1;  ///< from 1
  std::uint32_t trial = 0;   ///< the trial announced last; 0 before the first
};

/// A recording as a series of files, each complete in itself: schemas, channels, attachments, the
/// trial it is of. Each message is in exactly one. Errors are mcap::FileError. Not thread-safe.
class LogSeries {
 public:
  using Open = std::function<std::unique_ptr<mcap::Writer>(const Part&)>;

  /// `open` creates a file with what is to be at its beginning; `disk` says when there is no room
  /// for one. Opens the first at once if there is.
  LogSeries(Open open, const SeriesLimits& limits, DiskSpace disk);

  /// Channels are counted from 0 in the order of their coming.
  void add_channel(const ChannelSpec& spec);
  /// Only while there has_room().
  void write(const SampleBatch::Entry& entry, mcap::ByteView bytes);
  void note_loss(std::uint32_t channel, const Loss& loss);
  void close_chunk_if_due(std::uint64_t now_ns);

  /// False: the disk is too full for what waits (`pending_bytes`) to be written. Then the file has
  /// been closed; it goes on in a new one once there is room. Asks the disk now and then only.
  bool has_room(std::uint64_t pending_bytes);
  /// Why there is no room; empty when there is.
  const std::string& obstacle() const { return disk_.obstacle(); }

  const RecordingState& state() const { return state_; }
  /// Closes the file. Nothing can be written afterwards.
  void close();

 private:
  struct RecordedChannel {
    ChannelSpec spec;
    std::uint16_t id = 0;
  };
  /// What is counted for each file.
  struct PartCount {
    std::uint64_t messages = 0;
    std::uint64_t bytes = 0;
    std::uint64_t start_size = 0;     // of the file, before the first message
    std::uint64_t first_time_ns = 0;  // log time of the first message
    RecordedProgress progress;
    std::map<std::uint32_t, Loss> losses;
  };

  void open_part();
  void close_part();
  void introduce(RecordedChannel& channel);
  bool part_is_over(std::uint64_t log_time_ns) const;
  void begin_trial(mcap::ByteView bytes);
  mcap::Metadata closing_metadata() const;

  Open open_;
  SeriesLimits limits_;
  DiskSpace disk_;
  std::unique_ptr<mcap::Writer> writer_;  // none while there is no room
  std::vector<RecordedChannel> channels_;
  std::map<std::pair<std::string, std::string>, std::uint16_t> schema_ids_;  // by name and text
  TrialNote trial_;
  std::uint64_t missed_ticks_before_ = 0;
  PartCount part_;
  RecordingState state_;
};

}  // namespace scarab::logger
