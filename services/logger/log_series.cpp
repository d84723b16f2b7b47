#include "services/logger/log_series.hpp"

#include "services/logger/utc_time.hpp"

namespace scarab::logger {

LogSeries::LogSeries(Open open, const SeriesLimits& limits, DiskSpace disk)
    : open_(std::move(open)), limits_(limits), disk_(std::move(disk)) {
  has_room(0);
}

bool LogSeries::has_room(std::uint64_t pending_bytes) {
  const bool room = disk_.has_room(pending_bytes);
  if (!room && writer_) close_part();
  if (room && !writer_) open_part();
  return room;
}

void LogSeries::open_part() {
  writer_ = open_({state_.files + 1, trial_.number});
  ++state_.files;
  if (trial_.number > 0) writer_->add_metadata(trial_.metadata);
  schema_ids_.clear();
  for (RecordedChannel& channel : channels_) introduce(channel);
  part_ = {};
  part_.start_size = writer_->file_size();
  missed_ticks_before_ = state_.progress.missed_ticks();
}

void LogSeries::close_part() {
  writer_->add_metadata(closing_metadata());
  writer_->close();
  writer_.reset();
}

void LogSeries::introduce(RecordedChannel& channel) {
  const ChannelSpec& spec = channel.spec;
  const auto [entry, fresh] = schema_ids_.try_emplace({spec.type_name, spec.idl}, std::uint16_t{0});
  if (fresh) {
    // Of a type that is not known there is a schema all the same, the empty one that MCAP has for
    // it: readers that take for granted that each channel has one would refuse the whole file.
    const char* encoding = spec.idl.empty() ? "" : "omgidl";
    entry->second = writer_->add_schema(spec.type_name, encoding, spec.idl);
  }
  channel.id = writer_->add_channel(entry->second, spec.topic, "cdr", spec.metadata);
}

void LogSeries::add_channel(const ChannelSpec& spec) {
  channels_.push_back({spec, 0});
  if (writer_) introduce(channels_.back());
  ++state_.channels;
}

bool LogSeries::part_is_over(std::uint64_t log_time_ns) const {
  if (part_.messages == 0) return false;
  const auto file_time_ns = static_cast<std::uint64_t>(limits_.file_time.count());
  return (limits_.file_size_bytes > 0 &&
          writer_->file_size() - part_.start_size >= limits_.file_size_bytes) ||
         (file_time_ns > 0 && log_time_ns >= part_.first_time_ns + file_time_ns);
}

void LogSeries::begin_trial(mcap::ByteView bytes) {
  auto note = read_trial_note(bytes);
  if (!note || note->number <= trial_.number) return;
  trial_ = std::move(*note);
  if (!limits_.file_per_trial) {
    writer_->add_metadata(trial_.metadata);
    return;
  }
  close_part();
  open_part();
}

void LogSeries::write(const SampleBatch::Entry& entry, mcap::ByteView bytes) {
  const RecordedChannel& channel = channels_.at(entry.channel);
  if (channel.spec.role == TopicRole::kTrial) begin_trial(bytes);
  if (part_is_over(entry.log_time_ns)) {
    close_part();
    open_part();
  }
  writer_->write({channel.id, entry.sequence, entry.log_time_ns, entry.publish_time_ns, bytes});
  if (part_.messages++ == 0) part_.first_time_ns = entry.log_time_ns;
  part_.bytes += bytes.size();
  ++state_.messages;
  state_.bytes += bytes.size();
  if (channel.spec.role != TopicRole::kProgress) return;
  if (const auto header = read_sample_header(bytes.data(), bytes.size())) {
    state_.progress.note(*header);
    part_.progress.note(*header);
  }
}

void LogSeries::note_loss(std::uint32_t channel, const Loss& loss) {
  part_.losses[channel] += loss;
}

void LogSeries::close_chunk_if_due(std::uint64_t now_ns) {
  if (writer_) writer_->close_chunk_if_due(now_ns);
}

mcap::Metadata LogSeries::closing_metadata() const {
  Loss total;
  mcap::Metadata metadata{
      "scarab.recorded",
      {{"closed", utc_now()},
       {"trials", std::to_string(part_.progress.trials())},
       {"missed_ticks", std::to_string(state_.progress.missed_ticks() - missed_ticks_before_)},
       {"messages", std::to_string(part_.messages)},
       {"bytes", std::to_string(part_.bytes)}}};
  for (const auto& [channel, loss] : part_.losses) {
    const std::string& topic = channels_.at(channel).spec.topic;
    total += loss;
    if (loss.dropped > 0) metadata.entries["dropped." + topic] = std::to_string(loss.dropped);
    if (loss.lost > 0) metadata.entries["lost." + topic] = std::to_string(loss.lost);
  }
  metadata.entries["dropped"] = std::to_string(total.dropped);
  metadata.entries["lost"] = std::to_string(total.lost);
  return metadata;
}

void LogSeries::close() {
  if (writer_) close_part();
}

}  // namespace scarab::logger
