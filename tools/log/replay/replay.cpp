#include "tools/log/replay/replay.hpp"

#include <map>
#include <memory>
#include <stdexcept>

#include "common/bus/clock.hpp"
#include "common/bus/error.hpp"
#include "common/runtime/program.hpp"
#include "tools/log/progress_line.hpp"
#include "tools/log/replay/domain_check.hpp"
#include "tools/log/replay/excerpt.hpp"
#include "tools/log/replay/header_edit.hpp"
#include "tools/log/replay/pace.hpp"
#include "tools/log/replay/session.hpp"
#include "tools/log/replay/topic_writer.hpp"
#include "tools/log/words.hpp"

namespace scarab::log {
namespace {

using Clock = Session::Clock;

constexpr double kNsPerS = 1e9;

class Replay {
 public:
  Replay(const Log& log, const ReplayOptions& options, std::ostream& errors)
      : options_(options),
        excerpt_(log, options),
        session_(options.bus.participant("replay", 0)),
        line_("replaying"),
        pace_(options.speed) {
    if (!options.force) refuse_company(session_.participant(), excerpt_.topics());
    for (const std::string& topic : excerpt_.topics()) add_writers(topic, errors);
    if (writers_.empty()) throw std::invalid_argument("there is nothing to publish");
  }

  void run() {
    await_readers();
    do {
      started_ = false;
      excerpt_.for_each([&](TimedMessage& message) {
        publish(message);
        return true;
      });
      if (published_ == 0) {
        throw std::invalid_argument("no sample of the log is of such a trial and time");
      }
    } while (options_.loop);
    flush();
  }

  std::uint64_t published() const { return published_; }
  std::size_t topic_count() const { return topics().size(); }
  std::vector<std::string> late_readers() const { return late_; }

 private:
  std::set<std::string> topics() const {
    std::set<std::string> topics;
    for (const auto& [channel, writer] : writers_) topics.insert(channel->topic);
    return topics;
  }

  void add_writers(const std::string& topic, std::ostream& errors) {
    for (const LogChannel* channel : excerpt_.log().channels(topic)) {
      try {
        if (!find_writer_like(*channel)) {
          own_.push_back(std::make_unique<TopicWriter>(session_.participant(), *channel));
          writers_[channel] = own_.back().get();
        }
      } catch (const bus::Error& error) {
        errors << "scarab-log: left out: " << error.what() << '\n';
      }
    }
  }

  /// The parts of a split log have a channel each for what was one topic.
  bool find_writer_like(const LogChannel& channel) {
    for (const auto& [other, writer] : writers_) {
      const bool same = other->topic == channel.topic && other->type_name == channel.type_name &&
                        recorded_qos(*other) == recorded_qos(channel);
      if (same) {
        writers_[&channel] = writer;
        return true;
      }
    }
    return false;
  }

  std::size_t reader_count() const {
    std::size_t count = 0;
    for (const auto& writer : own_) count += writer->matched().size();
    return count;
  }

  /// A match counts once it is a while old: Cyclone drops what a volatile writer sends before its
  /// reader has seen a heartbeat.
  void await_readers() {
    constexpr std::chrono::milliseconds kPoll{5};
    constexpr std::chrono::milliseconds kHandshake{50};
    if (options_.wait_readers == 0) return;
    const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(options_.patience);
    while (reader_count() < options_.wait_readers) {
      if (Clock::now() > end) {
        throw std::runtime_error("only " + counted(reader_count(), "reader") + " of " +
                                 std::to_string(options_.wait_readers) + " after " +
                                 fixed_text(options_.patience.count(), 1) + " s");
      }
      line_.say("waits for " + counted(options_.wait_readers, "reader"));
      session_.sleep_until(Clock::now() + kPoll);
    }
    session_.sleep_until(Clock::now() + kHandshake);
  }

  void publish(TimedMessage& message) {
    const auto writer = writers_.find(message.channel);
    if (writer == writers_.end()) return;
    if (!started_) pace_.start(message.time_ns, Clock::now());
    started_ = true;
    session_.sleep_until(pace_.due(message.time_ns));
    if (options_.restamp && message.channel->has_header) set_stamp(message.cdr, bus::now_ns());
    if (options_.keep_times) {
      writer->second->write(message.cdr, static_cast<std::int64_t>(message.publish_time_ns));
    } else {
      writer->second->write(message.cdr);
    }
    ++published_;
    const double at_s =
        (static_cast<double>(message.time_ns) - static_cast<double>(excerpt_.begin_ns())) / kNsPerS;
    const double of_s = static_cast<double>(excerpt_.end_ns() - excerpt_.begin_ns()) / kNsPerS;
    line_.say(fixed_text(at_s, 1) + " of " + fixed_text(of_s, 1) + " s, " +
              counted(published_, "sample"));
  }

  void flush() {
    for (const auto& writer : own_) {
      if (!writer->flush(std::chrono::duration_cast<std::chrono::nanoseconds>(options_.patience))) {
        late_.push_back(writer->topic());
      }
    }
  }

  ReplayOptions options_;
  Excerpt excerpt_;
  Session session_;
  ProgressLine line_;
  Pace pace_;
  std::vector<std::unique_ptr<TopicWriter>> own_;
  std::map<const LogChannel*, TopicWriter*> writers_;
  bool started_ = false;
  std::uint64_t published_ = 0;
  std::vector<std::string> late_;
};

}  // namespace

int replay(const Log& log, const ReplayOptions& options, std::ostream& out, std::ostream& errors) {
  bool interrupted = false;
  Replay replay(log, options, errors);
  try {
    replay.run();
  } catch (const Interrupted&) {
    interrupted = true;
  }
  out << "replayed: " << counted(replay.published(), "sample") << " of "
      << counted(replay.topic_count(), "topic") << (interrupted ? ", then interrupted\n" : "\n");
  if (interrupted) return runtime::kExitInterrupted;
  for (const std::string& topic : replay.late_readers()) {
    errors << "scarab-log: " << topic << ": a reader has not acknowledged the last samples\n";
  }
  return replay.late_readers().empty() ? runtime::kExitSuccess : runtime::kExitFailure;
}

}  // namespace scarab::log
