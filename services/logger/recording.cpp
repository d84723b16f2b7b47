#include "services/logger/recording.hpp"

#include "common/bus/clock.hpp"

namespace scarab::logger {

Recording::Recording(std::unique_ptr<LogSeries> series, std::size_t queue_limit_bytes,
                     std::function<void()> notify)
    : series_(std::move(series)),
      queue_(queue_limit_bytes),
      notify_(std::move(notify)),
      thread_([this] { run(); }) {}

Recording::~Recording() { stop(); }

void Recording::stop() {
  queue_.close();
  if (thread_.joinable()) {
    thread_.join();
  }
}

RecordingState Recording::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

std::string Recording::obstacle() const {
  const std::lock_guard lock(mutex_);
  return obstacle_;
}

bool Recording::failed() const {
  const std::lock_guard lock(mutex_);
  return failure_ != nullptr;
}

void Recording::run() {
  // A chunk is not left open for long when the topics fall silent.
  constexpr std::chrono::milliseconds kSilence{100};
  try {
    while (!queue_.finished()) {
      if (!hold_while_no_room()) break;
      if (const auto batch = queue_.pop(kSilence)) {
        write(*batch);
      }
      series_->close_chunk_if_due(static_cast<std::uint64_t>(bus::now_ns()));
    }
  } catch (...) {
    queue_.close();
    const std::lock_guard lock(mutex_);
    failure_ = std::current_exception();
  }
  notify_();
}

/// False: nothing is left to write.
bool Recording::hold_while_no_room() {
  constexpr std::chrono::milliseconds kPoll{100};
  while (!series_->has_room(queue_.size_bytes())) {
    tell_obstacle(series_->obstacle());
    if (!queue_.wait_for_close(kPoll)) continue;
    if (queue_.finished()) return false;
    throw mcap::FileError(series_->obstacle());
  }
  tell_obstacle("");
  return true;
}

void Recording::tell_obstacle(const std::string& obstacle) {
  if (obstacle == obstacle_) return;  // only this thread changes it
  {
    const std::lock_guard lock(mutex_);
    obstacle_ = obstacle;
    state_ = series_->state();
  }
  notify_();
}

void Recording::write(const SampleBatch& batch) {
  for (const ChannelSpec& spec : batch.channels()) {
    series_->add_channel(spec);
  }
  for (const SampleBatch::Entry& entry : batch.entries()) {
    series_->write(entry, batch.bytes(entry));
  }
  for (const auto& [channel, loss] : batch.losses()) {
    series_->note_loss(channel, loss);
  }
  const RecordedProgress before = state_.progress;  // only this thread changes it
  {
    const std::lock_guard lock(mutex_);
    state_ = series_->state();
  }
  if (state_.progress.tick() != before.tick() || state_.progress.trial() != before.trial()) {
    notify_();
  }
}

void Recording::close() {
  stop();
  if (failure_ != nullptr) {
    std::rethrow_exception(failure_);
  }
  series_->close();
}

}  // namespace scarab::logger
