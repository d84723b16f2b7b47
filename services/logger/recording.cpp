#include "services/logger/recording.hpp"

#include "common/bus/clock.hpp"

namespace scarab::logger {

Recording::Recording(std::unique_ptr<mcap::Writer> writer, std::size_t queue_limit_bytes,
                     std::function<void()> notify)
    : writer_(std::move(writer)),
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

bool Recording::failed() const {
  const std::lock_guard lock(mutex_);
  return failure_ != nullptr;
}

void Recording::run() {
  // A chunk is not left open for long when the topics fall silent.
  constexpr std::chrono::milliseconds kSilence{100};
  try {
    while (!queue_.finished()) {
      if (const auto batch = queue_.pop(kSilence)) {
        write(*batch);
      }
      writer_->close_chunk_if_due(static_cast<std::uint64_t>(bus::now_ns()));
    }
  } catch (...) {
    queue_.close();
    const std::lock_guard lock(mutex_);
    failure_ = std::current_exception();
  }
  notify_();
}

void Recording::add_channel(const ChannelSpec& spec) {
  std::uint16_t schema = 0;
  if (!spec.idl.empty()) {
    const auto [entry, fresh] = schema_ids_.try_emplace(spec.idl, std::uint16_t{0});
    if (fresh) {
      entry->second = writer_->add_schema(spec.type_name, "omgidl", spec.idl);
    }
    schema = entry->second;
  }
  channels_.push_back({writer_->add_channel(schema, spec.topic, "cdr", {{"type", spec.type_name}}),
                       spec.shows_progress});
}

void Recording::write(const SampleBatch& batch) {
  for (const ChannelSpec& spec : batch.channels()) {
    add_channel(spec);
  }
  RecordingState state = state_;  // only this thread changes it
  for (const SampleBatch::Entry& entry : batch.entries()) {
    const RecordedChannel& channel = channels_.at(entry.channel);
    const mcap::ByteView bytes = batch.bytes(entry);
    writer_->write({channel.id, entry.sequence, entry.log_time_ns, entry.publish_time_ns, bytes});
    state.bytes += bytes.size();
    if (!channel.shows_progress) {
      continue;
    }
    if (const auto header = read_sample_header(bytes.data(), bytes.size())) {
      state.progress.note(*header);
    }
  }
  state.messages += batch.entries().size();
  state.channels = static_cast<std::uint32_t>(channels_.size());
  const bool moved = state.progress.tick() != state_.progress.tick() ||
                     state.progress.trial() != state_.progress.trial();
  {
    const std::lock_guard lock(mutex_);
    state_ = state;
  }
  if (moved) {
    notify_();
  }
}

void Recording::close(const std::function<mcap::Metadata(const RecordingState&)>& final_metadata) {
  stop();
  if (failure_ != nullptr) {
    std::rethrow_exception(failure_);
  }
  writer_->add_metadata(final_metadata(state_));
  writer_->close();
}

}  // namespace scarab::logger
