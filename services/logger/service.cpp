#include "services/logger/service.hpp"

#include <chrono>
#include <csignal>
#include <optional>
#include <thread>

#include "common/runtime/polite_threads.hpp"
#include "common/runtime/shutdown.hpp"
#include "services/logger/core/chain_writers.hpp"
#include "services/logger/log_file.hpp"
#include "services/logger/recording.hpp"
#include "services/logger/stack_watch.hpp"
#include "services/logger/status_report.hpp"
#include "services/logger/topic_recorder.hpp"

namespace scarab::logger {
namespace {

using Clock = std::chrono::steady_clock;

class Recorder {
 public:
  Recorder(bus::Participant& participant, const LoggerOptions& options, const LoggerConfig& config)
      : needed_(chain_writers(options.service.expect)),
        take_interval_(config.take_interval_s),
        most_queued_bytes_((config.queue_mib << 20U) + kChainBytes),
        stop_guard_(participant),
        news_guard_(participant),
        wait_set_(participant),
        status_(participant, participant.self()),
        topics_(participant, wait_set_),
        recording_(open_series(options, config), config.queue_mib << 20U,
                   [this] { news_guard_.trigger(); }),
        shutdown_(stop_guard_) {
    wait_set_.attach(stop_guard_);
    wait_set_.attach(news_guard_);
  }

  void run() {
    while (!shutdown_.requested() && !recording_.failed()) {
      const bool took = may_take() && record();
      check_readiness();
      report();
      if (took) {
        // What comes meanwhile is taken in one go: fewer wake-ups, and the chain keeps its core.
        std::this_thread::sleep_for(take_interval_);
      }
    }
    finish();
  }

 private:
  static constexpr std::chrono::milliseconds kPeerPoll{5};
  static constexpr std::chrono::milliseconds kHoldPoll{20};
  static constexpr std::chrono::seconds kLongestHold{5};
  /// 64 ticks of the chain are about 1 MiB.
  static constexpr std::size_t kChainBytes = std::size_t{16} << 20U;
  static constexpr std::chrono::seconds kPatience{1};

  std::chrono::nanoseconds next_wake_up() const {
    const bool waits_for_peers = watch_.trial() != status_.ready_trial();
    const auto until_report = status_.time_left();
    return waits_for_peers ? std::min<std::chrono::nanoseconds>(kPeerPoll, until_report)
                           : until_report;
  }

  /// Waits for news. False: the queue is full and the stack waits for what is in it, so samples
  /// stay with the bus; but not for long, as not everybody may be waiting.
  bool may_take() {
    if (recording_.full() && watch_.in_lockstep(Clock::now())) {
      if (!held_since_) held_since_ = Clock::now();
      if (!recording_.wait_for_room(kHoldPoll) && Clock::now() - *held_since_ < kLongestHold) {
        return false;
      }
    } else {
      wait_set_.wait(next_wake_up());
    }
    held_since_.reset();
    news_guard_.clear();
    return true;
  }

  bool record() {
    SampleBatch batch = topics_.take();
    if (batch.empty()) return false;
    const bool took = !batch.entries().empty();
    const bool was_in_lockstep = watch_.in_lockstep(Clock::now());
    watch_.note(batch, Clock::now());
    if (recording_.full()) {
      drop_from(batch, was_in_lockstep || watch_.in_lockstep(Clock::now()));
    }
    losses_.note(batch);
    recording_.push(std::move(batch));
    return took;
  }

  /// Nothing of a chain that waits: the bound is not reached by what it can be ahead. The trial's
  /// own sample is kept always: there is one a trial.
  void drop_from(SampleBatch& batch, bool in_lockstep) {
    const bool keep_chain = in_lockstep && recording_.queued_bytes() < most_queued_bytes_;
    batch.drop_samples([&](std::uint32_t channel) {
      const TopicRole role = watch_.role_of(channel);
      return role == TopicRole::kTrial || (keep_chain && role != TopicRole::kNone);
    });
  }

  void check_readiness() {
    if (watch_.trial() != trial_) {
      trial_ = watch_.trial();
      trial_since_ = Clock::now();
    }
    if (trial_ == status_.ready_trial() || !recording_.obstacle().empty()) return;
    const auto missing = topics_.missing(needed_);
    if (missing.empty()) {
      status_.ready(trial_);
    } else if (Clock::now() - trial_since_ > kPatience) {
      status_.waits_for(missing);
    }
  }

  void report() {
    const RecordingState state = recording_.state();
    status_.recorded(state, losses_.total());
    const std::string obstacle = recording_.obstacle();
    // Asking the bus costs more than all else here, and losses do not pass.
    constexpr std::chrono::milliseconds kFaultPeriod{500};
    if (!obstacle.empty()) {
      status_.held_up(obstacle);
      faults_checked_ = {};
    } else if (trial_ == status_.ready_trial() && Clock::now() - faults_checked_ > kFaultPeriod) {
      faults_checked_ = Clock::now();
      count_losses();
      status_.works(state, losses_, topics_.faults());
    }
    status_.publish_if_due();
  }

  /// Those of the bus.
  void count_losses() {
    SampleBatch batch = topics_.losses();
    if (batch.empty()) return;
    losses_.note(batch);
    recording_.push(std::move(batch));
  }

  /// The farewell is recorded too; then what is still on its way, until the topics are silent. A
  /// stack that lives on is not waited for.
  void finish() {
    constexpr std::chrono::milliseconds kSilence{20};
    constexpr std::chrono::seconds kLongest{1};
    status_.farewell(recording_.failed() ? "cannot write the log" : recording_.obstacle());
    stop_guard_.clear();
    const auto end = Clock::now() + kLongest;
    while (!recording_.failed() && Clock::now() < end && wait_set_.wait(kSilence)) {
      news_guard_.clear();
      if (recording_.wait_for_room(kHoldPoll)) record();
    }
    record();
    count_losses();
    recording_.close();
  }

  std::vector<ChainWriter> needed_;
  std::chrono::duration<double> take_interval_;
  std::size_t most_queued_bytes_;
  bus::Guard stop_guard_;
  bus::Guard news_guard_;
  bus::WaitSet wait_set_;
  StatusReport status_;
  TopicRecorder topics_;
  StackWatch watch_;
  LossAccount losses_;
  Recording recording_;
  runtime::Shutdown shutdown_;

  std::optional<Clock::time_point> held_since_;
  std::uint32_t trial_ = 0;
  Clock::time_point trial_since_{};
  Clock::time_point faults_checked_{};
};

}  // namespace

void serve(const LoggerOptions& options, const LoggerConfig& config) {
  // A limit on file sizes is to be an error of write() like a full disk, not the end of the
  // process.
  std::signal(SIGXFSZ, SIG_IGN);
  runtime::be_polite();
  bus::Participant participant(options.service.bus.participant("logger", options.service.instance));
  Recorder recorder(participant, options, config);
  recorder.run();
}

}  // namespace scarab::logger
