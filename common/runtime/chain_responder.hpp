#pragma once

#include <algorithm>
#include <chrono>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/bus/reader.hpp"
#include "common/bus/topics.hpp"
#include "common/bus/waitset.hpp"
#include "common/runtime/options.hpp"
#include "common/runtime/peers.hpp"
#include "common/runtime/shutdown.hpp"
#include "common/runtime/state_file.hpp"
#include "common/runtime/status_publisher.hpp"

namespace scarab::runtime {

/// A stateful service of the reactive chain (design: "Time: one reactive chain"): it answers
/// question k of the running trial from its state k-1 alone, and keeps state k on disk before
/// answer k goes out. So it can be killed and restarted at any moment: it gives the same answer if
/// it had answered already, the next one if not.
///
/// Link supplies:
///  - `Question`, an IDL type with a Header, and `State`, trivially copyable;
///  - `kStateLayout`, a std::uint32_t that changes when State does;
///  - `void begin(const scarab_Trial&, State&)`: the state at tick -1; throws std::exception on a
///  bad
///    trial;
///  - `void advance(State&, const Question&)`: from state k-1 to state k;
///  - `void answer(const State&, const Question&)`: publishes the answer of state k;
///  - `bool ends(const Question&)`: this question is the trial's last;
///  - `std::optional<RecordKey> adopt(std::uint32_t trial, State&)`: a living replica's state that
///    came over the bus, if there is one (those on the same host are found by their files);
///  - `bool has_replica()`: a replica lives whose state may still come;
///  - `void report(StatusPublisher&)`: adds what the link alone knows; called whenever the bus has
///    been looked at.
///
/// In lockstep nothing is ever missed. In real time the chain does not wait for a service that was
/// away: it catches up through the missed ticks with the first question it gets, so that the
/// state's time goes on.
template <class Link>
class ChainResponder {
 public:
  using Question = typename Link::Question;
  using State = typename Link::State;

  ChainResponder(bus::Participant& participant, const ServiceOptions& options,
                 const bus::Peer& self, const bus::Topic<Question>& question, Link& link,
                 PeerCheck& peers)
      : link_(link),
        peers_(peers),
        guard_(participant),
        wait_set_(participant),
        trials_(participant, bus::kTrial),
        questions_(participant, question),
        status_(participant, self),
        shutdown_(guard_) {
    if (!options.run_dir.empty()) {
      const auto directory = options.run_dir / "state";
      std::filesystem::create_directories(directory);
      file_.emplace(state_path(directory, self), Link::kStateLayout);
      replica_files_ = replica_paths(directory, self, options.expect);
    }
    wait_set_.attach(trials_);
    wait_set_.attach(questions_);
    wait_set_.attach(guard_);
    status_.set_lifecycle(scarab_LIFECYCLE_INACTIVE);
  }

  [[nodiscard]] bus::Reader<Question>& questions() { return questions_; }

  /// Serves until SIGINT or SIGTERM.
  void run() {
    status_.publish_if_due();
    while (!shutdown_.requested()) {
      // While peers are missing their arrival is looked for every few milliseconds; else only
      // samples wake us.
      wait_set_.wait(waiting_for_peers() || !held_.empty() ? kPeerPoll : kIdlePoll);
      take_trials();
      take_questions();
      if (waiting_for_peers()) check_peers();
      if (ready_) answer_held();
      link_.report(status_);
      status_.publish_if_due();
    }
    status_.set_lifecycle(scarab_LIFECYCLE_FINALISED);
    status_.publish_if_due();
  }

 private:
  static constexpr std::chrono::milliseconds kPeerPoll{5};
  static constexpr std::chrono::milliseconds kIdlePoll{200};
  static constexpr std::chrono::seconds kPatience{1};
  static constexpr std::size_t kHeldMost = 128;
  static constexpr std::int64_t kCatchUpMost = 6000;  // ten minutes: older than any memory

  static std::filesystem::path state_path(const std::filesystem::path& directory,
                                          const bus::Peer& peer) {
    return directory / (peer.service + "-" + std::to_string(peer.instance) + ".state");
  }

  static std::vector<std::filesystem::path> replica_paths(const std::filesystem::path& directory,
                                                          const bus::Peer& self,
                                                          const Expectation& expect) {
    std::vector<std::filesystem::path> paths;
    const auto own = expect.find(self.service);
    const std::uint32_t count = own == expect.end() ? 0 : own->second;
    for (bus::Peer other{self.service, 0}; other.instance < count; ++other.instance) {
      if (other != self) paths.push_back(state_path(directory, other));
    }
    return paths;
  }

  [[nodiscard]] bool waiting_for_peers() const { return trial_ != 0 && !ready_; }

  void take_trials() {
    trials_.take([this](const scarab_Trial& trial) {
      if (trial.header.trial > trial_) begin(trial);
    });
  }

  void begin(const scarab_Trial& trial) {
    trial_ = trial.header.trial;
    ready_ = false;
    gap_since_.reset();
    waiting_since_ = std::chrono::steady_clock::now();
    tick_ = -1;
    status_.set_lifecycle(scarab_LIFECYCLE_INACTIVE);
    try {
      link_.begin(trial, state_);
    } catch (const std::exception& error) {
      refused_ = true;
      status_.set_health(scarab_HEALTH_FAULT,
                         "trial " + std::to_string(trial_) + ": " + error.what());
      return;
    }
    refused_ = false;
    State kept;
    const auto key = file_ ? file_->read(kept) : std::nullopt;
    if (key && key->trial == trial_) {
      state_ = kept;
      tick_ = key->tick;
    }
    status_.set_health(scarab_HEALTH_OK);
  }

  void take_questions() {
    questions_.take([this](const Question& question) {
      if (question.header.trial < trial_) return;
      held_.push_back(question);
      if (held_.size() > kHeldMost) held_.pop_front();
    });
  }

  void check_peers() {
    if (refused_) return;
    const auto unmet = peers_.unmet();
    if (unmet.empty()) {
      ready_ = true;
      status_.set_health(scarab_HEALTH_OK);
      status_.set_lifecycle(scarab_LIFECYCLE_ACTIVE);
      status_.set_ready(trial_);
    } else if (std::chrono::steady_clock::now() - waiting_since_ > kPatience) {
      status_.set_health(scarab_HEALTH_WAITING, "waits for " + join(unmet));
    }
  }

  void answer_held() {
    while (!held_.empty() && held_.front().header.trial <= trial_) {
      if (held_.front().header.trial == trial_ && !answer(held_.front())) return;
      held_.pop_front();
    }
  }

  /// False: cannot yet, for a replica's state may still come.
  bool answer(const Question& question) {
    const auto tick = static_cast<std::int64_t>(question.header.tick);
    if (tick > tick_ + 1) adopt_replica();
    if (tick > tick_ + 1 && question.real_time && !awaits_replica()) catch_up(question);
    if (tick > tick_ + 1) return give_up(tick);
    gap_since_.reset();
    if (tick < tick_) return true;
    if (tick == tick_ + 1) {
      link_.advance(state_, question);
      tick_ = tick;
      if (file_) file_->write({trial_, tick_}, state_);
    }
    link_.answer(state_, question);
    status_.set_progress(question.header);
    if (link_.ends(question)) status_.set_lifecycle(scarab_LIFECYCLE_INACTIVE);
    return true;
  }

  /// From the bus, or on the same host from what it has kept before it answered.
  void adopt_replica() {
    State living;
    const std::int64_t before = tick_;
    adopt(link_.adopt(trial_, living), living);
    for (const auto& path : replica_files_) {
      adopt(TypedStateFile<State>::peek(path, Link::kStateLayout, living), living);
    }
    if (tick_ == before) return;
    status_.set_health(scarab_HEALTH_OK,
                       "took over the state of a living replica at tick " + std::to_string(tick_));
  }

  void adopt(const std::optional<RecordKey>& key, const State& living) {
    if (!key || key->trial != trial_ || key->tick <= tick_) return;
    state_ = living;
    tick_ = key->tick;
  }

  /// For a while after a gap has shown.
  bool awaits_replica() {
    const auto now = std::chrono::steady_clock::now();
    if (!gap_since_) gap_since_ = now;
    return link_.has_replica() && now - *gap_since_ < kPatience;
  }

  /// Up to the tick before the question's, as if it had been asked in each of them.
  void catch_up(const Question& question) {
    const auto tick = static_cast<std::int64_t>(question.header.tick);
    const std::int64_t missed = tick - 1 - tick_;
    Question past = question;
    for (tick_ = std::max(tick_, tick - 1 - kCatchUpMost); tick_ < tick - 1; ++tick_) {
      past.header.tick = static_cast<std::uint32_t>(tick_ + 1);
      link_.advance(state_, past);
    }
    ticks_missed_ += static_cast<std::uint64_t>(missed);
    status_.set_counter("ticks_missed", ticks_missed_);
    status_.set_health(scarab_HEALTH_OK, "caught up at tick " + std::to_string(tick) + " after " +
                                             std::to_string(missed) + " missed ticks");
  }

  /// Once a gap has lasted: reports it, true.
  bool give_up(std::int64_t tick) {
    const auto now = std::chrono::steady_clock::now();
    if (!gap_since_) gap_since_ = now;
    if (now - *gap_since_ < kPatience) return false;
    status_.set_health(scarab_HEALTH_FAULT, "cannot answer tick " + std::to_string(tick) +
                                                ": last state is of tick " + std::to_string(tick_));
    return true;
  }

  Link& link_;
  PeerCheck& peers_;
  bus::Guard guard_;
  bus::WaitSet wait_set_;
  bus::Reader<scarab_Trial> trials_;
  bus::Reader<Question> questions_;
  StatusPublisher status_;
  std::optional<TypedStateFile<State>> file_;
  std::vector<std::filesystem::path> replica_files_;
  Shutdown shutdown_;

  std::uint32_t trial_ = 0;
  std::int64_t tick_ = -1;  // last tick answered
  bool ready_ = false;
  bool refused_ = false;
  std::chrono::steady_clock::time_point waiting_since_{};
  std::optional<std::chrono::steady_clock::time_point> gap_since_;  // questions are ahead of state_
  State state_{};
  std::deque<Question> held_;
  std::uint64_t ticks_missed_ = 0;
};

}  // namespace scarab::runtime
