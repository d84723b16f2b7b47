#include "services/logger/service.hpp"

#include <spdlog/spdlog.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "common/bus/reader.hpp"
#include "common/bus/topics.hpp"
#include "common/runtime/peers.hpp"
#include "common/runtime/shutdown.hpp"
#include "common/runtime/status_publisher.hpp"
#include "services/logger/core/chain_writers.hpp"
#include "services/logger/log_file.hpp"
#include "services/logger/recording.hpp"
#include "services/logger/topic_recorder.hpp"

namespace scarab::logger {
namespace {

using Clock = std::chrono::steady_clock;

class Recorder {
 public:
  Recorder(bus::Participant& participant, const LoggerOptions& options, const LoggerConfig& config)
      : needed_(chain_writers(options.service.expect)),
        take_interval_(config.take_interval_s),
        stop_guard_(participant),
        news_guard_(participant),
        wait_set_(participant),
        trials_(participant, bus::kTrial),
        status_(participant, participant.self()),
        topics_(participant, wait_set_),
        recording_(open_log(options, config), config.queue_mib << 20U,
                   [this] { news_guard_.trigger(); }),
        shutdown_(stop_guard_) {
    wait_set_.attach(stop_guard_);
    wait_set_.attach(news_guard_);
    wait_set_.attach(trials_);
    status_.set_lifecycle(scarab_LIFECYCLE_INACTIVE);
    status_.publish_if_due();
  }

  void run() {
    while (!shutdown_.requested() && !recording_.failed()) {
      wait_set_.wait(next_wake_up());
      news_guard_.clear();
      take_trials();
      const bool took = record();
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
  static constexpr std::chrono::seconds kPatience{1};

  std::chrono::nanoseconds next_wake_up() const {
    const bool waits_for_peers = trial_ != ready_trial_;
    const auto until_report = status_.time_left();
    return waits_for_peers ? std::min<std::chrono::nanoseconds>(kPeerPoll, until_report)
                           : until_report;
  }

  void take_trials() {
    trials_.take([this](const scarab_Trial& trial) {
      if (trial.header.trial <= trial_) return;
      trial_ = trial.header.trial;
      trial_since_ = Clock::now();
    });
  }

  bool record() {
    SampleBatch batch = topics_.take();
    if (batch.empty()) return false;
    const bool took = !batch.entries().empty();
    recording_.push(std::move(batch));
    return took;
  }

  void check_readiness() {
    if (trial_ == ready_trial_) return;
    const auto missing = topics_.missing(needed_);
    if (missing.empty()) {
      ready_trial_ = trial_;
      status_.set_ready(trial_);
      status_.set_lifecycle(scarab_LIFECYCLE_ACTIVE);
      status_.set_health(scarab_HEALTH_OK);
    } else if (Clock::now() - trial_since_ > kPatience) {
      status_.set_health(scarab_HEALTH_WAITING, "waits for " + runtime::join(missing));
    }
  }

  void report() {
    const RecordingState state = recording_.state();
    status_.set_recorded(state.progress.trial(), state.progress.tick());
    status_.set_counter("messages", state.messages);
    status_.set_counter("bytes", state.bytes);
    status_.set_counter("channels", state.channels);
    status_.set_counter("missed_ticks", state.progress.missed_ticks());
    if (trial_ == ready_trial_) report_losses(state);
    status_.publish_if_due();
  }

  void report_losses(const RecordingState& state) {
    // Asking the bus costs more than all else here, and losses do not pass.
    constexpr std::chrono::milliseconds kFaultPeriod{500};
    if (Clock::now() - faults_checked_ < kFaultPeriod) return;
    faults_checked_ = Clock::now();
    std::vector<std::string> losses = topics_.faults();
    if (state.progress.missed_ticks() > 0) {
      losses.push_back(std::to_string(state.progress.missed_ticks()) +
                       " ticks of robot_state missed");
    }
    status_.set_counter("faults", losses.size());
    if (losses.empty()) {
      status_.set_health(scarab_HEALTH_OK);
    } else {
      status_.set_health(scarab_HEALTH_DEGRADED, runtime::join(losses));
    }
  }

  /// The farewell is recorded too; then what is still on its way, until the topics are silent. A
  /// stack that lives on is not waited for.
  void finish() {
    constexpr std::chrono::milliseconds kSilence{20};
    constexpr std::chrono::seconds kLongest{1};
    status_.set_lifecycle(scarab_LIFECYCLE_FINALISED);
    if (recording_.failed()) status_.set_health(scarab_HEALTH_FAULT, "cannot write the log");
    status_.publish_if_due();
    stop_guard_.clear();
    const auto end = Clock::now() + kLongest;
    while (!recording_.failed() && Clock::now() < end && wait_set_.wait(kSilence)) {
      news_guard_.clear();
      trials_.take([](const scarab_Trial&) {});
      record();
    }
    record();
    recording_.close(closing_metadata);
  }

  std::vector<ChainWriter> needed_;
  std::chrono::duration<double> take_interval_;
  bus::Guard stop_guard_;
  bus::Guard news_guard_;
  bus::WaitSet wait_set_;
  bus::Reader<scarab_Trial> trials_;
  runtime::StatusPublisher status_;
  TopicRecorder topics_;
  Recording recording_;
  runtime::Shutdown shutdown_;

  std::uint32_t trial_ = 0;
  std::uint32_t ready_trial_ = 0;
  Clock::time_point trial_since_{};
  Clock::time_point faults_checked_{};
};

}  // namespace

void serve(const LoggerOptions& options, const LoggerConfig& config) {
  // A limit on file sizes is to be an error of write() like a full disk, not the end of the
  // process.
  std::signal(SIGXFSZ, SIG_IGN);
  bus::Participant participant(options.service.bus.participant("logger", options.service.instance));
  Recorder recorder(participant, options, config);
  recorder.run();
}

}  // namespace scarab::logger
