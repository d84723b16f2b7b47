#include "tools/status/status.hpp"

#include <algorithm>
#include <chrono>
#include <iostream>

#include "common/bus/discovery.hpp"
#include "common/bus/participants.hpp"
#include "common/bus/waitset.hpp"
#include "common/runtime/peers.hpp"
#include "common/runtime/program.hpp"
#include "common/runtime/shutdown.hpp"
#include "tools/status/report.hpp"

namespace scarab::status {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr std::chrono::milliseconds kPoll{20};
constexpr Seconds kDiscovery{1.0};  // nobody can say that there is nobody

/// How those waited for are.
struct Readiness {
  bool all_there = true;
  bool fault = false;
  std::vector<std::string> troubles;  ///< what is not as it should be, a few words each

  [[nodiscard]] bool settled() const { return troubles.empty() || (all_there && fault); }
};

Readiness readiness(const runtime::StatusBoard& board, const runtime::Expectation& wait_for) {
  Readiness found;
  found.troubles = board.missing(wait_for, 0);
  found.all_there = found.troubles.empty();
  for (auto& name : found.troubles) name += " is missing";
  for (const auto& [peer, report] : board.reports()) {
    if (wait_for.count(peer.service) == 0) continue;
    const std::string name = bus::to_string(peer);
    if (report.health == scarab_HEALTH_FAULT) {
      found.fault = true;
      found.troubles.push_back(name + ": " + report.message);
    } else if (report.lifecycle != scarab_LIFECYCLE_INACTIVE &&
               report.lifecycle != scarab_LIFECYCLE_ACTIVE) {
      const std::string why = report.message.empty() ? "" : ": " + report.message;
      found.troubles.push_back(name + " is not configured" + why);
    }
  }
  return found;
}

/// Tells a person what a long wait is for.
class Progress {
 public:
  void tell(const std::vector<std::string>& troubles) {
    const std::string text = runtime::join(troubles);
    if (text.empty() || text == told_ || Clock::now() - since_ < kPatience) return;
    std::cerr << "scarab-status: waiting: " << text << std::endl;
    told_ = text;
  }

 private:
  static constexpr Seconds kPatience{2.0};
  Clock::time_point since_ = Clock::now();
  std::string told_;
};

/// A participant that looks on.
class Onlooker {
 public:
  explicit Onlooker(const runtime::BusOptions& options)
      : participant_(options.participant("status", 0)),
        board_(participant_),
        discovery_(participant_),
        participants_(participant_),
        guard_(participant_),
        shutdown_(guard_),
        wait_set_(participant_) {
    wait_set_.attach(board_.reader());
    wait_set_.attach(guard_);
  }

  /// For this long, or until a request to stop.
  void look(Seconds time) {
    look_until(time, [] { return false; });
  }
  /// Until all of these are there and well, or there and faulty; at most `limit`.
  void await(const runtime::Expectation& services, Seconds limit, bool with_progress) {
    Progress progress;
    look_until(limit, [&] {
      const Readiness now = readiness(board_, services);
      if (with_progress) progress.tell(now.troubles);
      return now.settled();
    });
  }

  [[nodiscard]] bool asked_to_stop() const { return shutdown_.requested(); }
  [[nodiscard]] const runtime::StatusBoard& board() const { return board_; }

  /// What is known now.
  Snapshot snapshot() {
    participants_.update();
    discovery_.update();
    Snapshot snapshot;
    for (const auto& endpoint : discovery_.endpoints()) {
      if (endpoint.kind == bus::EndpointKind::kWriter && endpoint.topic == bus::kRobotState.name) {
        snapshot.tick_master = bus::to_string(endpoint.peer);
      }
    }
    for (const auto& [peer, report] : board_.reports()) {
      snapshot.services.push_back({report, host_of(peer), rates_.of(peer, Clock::now())});
    }
    return snapshot;
  }

 private:
  template <class Done>
  void look_until(Seconds limit, Done&& done) {
    const auto since = Clock::now();
    while (!asked_to_stop() && Clock::now() - since < limit && !done()) {
      wait_set_.wait(kPoll);
      board_.update();
      rates_.observe(board_.reports(), Clock::now());
    }
  }
  [[nodiscard]] std::string host_of(const bus::Peer& peer) const {
    for (const auto& [guid, participant] : participants_.all()) {
      if (participant.peer == peer) return participant.host;
    }
    return {};
  }

  bus::Participant participant_;
  runtime::StatusBoard board_;
  bus::Discovery discovery_;
  bus::Participants participants_;
  bus::Guard guard_;
  runtime::Shutdown shutdown_;
  bus::WaitSet wait_set_;
  RateMeter rates_;
};

void print(const Snapshot& snapshot, bool as_json) {
  std::cout << (as_json ? json(snapshot) : table(snapshot)) << std::flush;
}

}  // namespace

int show(const StatusOptions& options) {
  Onlooker onlooker(options.bus);
  const bool waiting = !options.wait_for.empty();
  onlooker.look(waiting ? Seconds(options.look_s) : std::max(Seconds(options.look_s), kDiscovery));
  if (waiting)
    onlooker.await(options.wait_for, Seconds(options.timeout_s - options.look_s), options.progress);
  if (onlooker.asked_to_stop()) return runtime::kExitInterrupted;
  print(onlooker.snapshot(), options.json);
  if (waiting) {
    const auto left = readiness(onlooker.board(), options.wait_for).troubles;
    if (left.empty()) return runtime::kExitSuccess;
    std::cerr << "scarab-status: " << runtime::join(left) << '\n';
    return runtime::kExitFailure;
  }
  if (!onlooker.board().reports().empty()) return runtime::kExitSuccess;
  std::cerr << "scarab-status: no services found\n";
  return runtime::kExitFailure;
}

int watch(const StatusOptions& options) {
  Onlooker onlooker(options.bus);
  if (!options.wait_for.empty())
    onlooker.await(options.wait_for, Seconds(options.timeout_s), options.progress);
  while (!onlooker.asked_to_stop() && std::cout) {
    onlooker.look(Seconds(options.period_s));
    if (!onlooker.asked_to_stop()) print(onlooker.snapshot(), options.json);
  }
  return runtime::kExitSuccess;
}

}  // namespace scarab::status
