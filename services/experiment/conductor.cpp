#include "services/experiment/conductor.hpp"

#include <algorithm>
#include <thread>

#include "common/bus/clock.hpp"
#include "common/runtime/end_words.hpp"
#include "common/runtime/tick_masters.hpp"

namespace scarab::experiment {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPoll{5};
constexpr std::chrono::milliseconds kWatchPoll{50};
constexpr std::chrono::seconds kPatience{1};
// Samples come by the thousand a second. Those of such a while are taken in one go: fewer wake-ups,
// and the chain keeps its core.
constexpr std::chrono::milliseconds kTakeInterval{2};
constexpr std::chrono::seconds kRecordLimit{10};
constexpr const char* kSimulator = "plant";  // the tick master that is its world's referee, too

bus::ReaderOptions every_sample() {
  bus::ReaderOptions options;
  options.keep_all = true;
  return options;
}

}  // namespace

Conductor::Conductor(bus::Participant& participant, const runtime::Expectation& expect,
                     Listener listener, FaultFile fault)
    : expect_(expect),
      tick_master_(runtime::expected_tick_master(expect)),
      listener_(std::move(listener)),
      fault_(std::move(fault)),
      peers_(expect),
      guard_(participant),
      wait_set_(participant),
      trials_(participant, bus::kTrial),
      behaviours_(participant, bus::kBehaviour, every_sample()),
      worlds_(participant, bus::kWorldState, every_sample()),
      board_(participant),
      shutdown_(guard_) {
  wait_set_.attach(behaviours_);
  wait_set_.attach(worlds_);
  wait_set_.attach(board_.reader());
  wait_set_.attach(guard_);
  for (const auto& [service, count] : expect_) peers_.need(trials_, service);
  peers_.need(behaviours_, "supervisor");
  peers_.need(worlds_, kSimulator);
  if (!tick_master_ || tick_master_->service == kSimulator) return;
  // A robot: whoever sees its world, if anybody does, is none of the stack.
  states_.emplace(participant, bus::kRobotState, every_sample());
  wait_set_.attach(*states_);
  runtime::need_tick_master(peers_, *states_);
}

void Conductor::await_stack(std::chrono::seconds limit) {
  const auto since = Clock::now();
  for (;;) {
    auto unmet = peers_.unmet();
    for (const auto& name : board_.missing(expect_, 0)) unmet.push_back(name + " to come up");
    if (unmet.empty()) return;
    if (const auto fault = fault_.reason()) throw NotReady(*fault);
    const auto waited = Clock::now() - since;
    if (waited > limit)
      throw NotReady("waited " + std::to_string(limit.count()) + " s for " + runtime::join(unmet));
    if (waited > kPatience && listener_.waiting) listener_.waiting(runtime::join(unmet));
    wait(kPoll);
  }
}

std::uint32_t Conductor::next_trial() const {
  std::uint32_t newest = 0;
  for (const auto& [peer, report] : board_.reports()) {
    newest = std::max({newest, report.header.trial, report.ready_trial, report.recorded_trial});
  }
  return newest + 1;
}

Outcome Conductor::run(scarab_Trial trial, std::chrono::seconds silence_limit) {
  TrialWatch watch(trial, states_ ? Judge::kTickMaster : Judge::kReferee);
  watch_ = &watch;
  told_ = heard_ = Clock::now();
  master_missed_.reset();
  master_gone_ = false;
  told_ns_ = trial.header.stamp_ns = bus::now_ns();
  trials_.write(trial);
  std::size_t shown = 0;
  for (auto due = told_; !watch.ended();) {
    wait(kWatchPoll);
    show_changes(watch.outcome(), shown);
    if (!watch.ended()) std::this_thread::sleep_for(kTakeInterval);
    if (Clock::now() < due) continue;
    due = Clock::now() + kWatchPoll;
    if (listener_.progress) listener_.progress(watch.outcome().end);
    watch_for_trouble(watch, silence_limit);
  }
  await_record(watch);
  await_reason(watch);
  show_changes(watch.outcome(), shown);
  watch_ = nullptr;
  return watch.outcome();
}

void Conductor::wait(std::chrono::milliseconds timeout) {
  wait_set_.wait(timeout);
  if (shutdown_.requested()) throw Interrupted{};
  board_.update();
  const auto see = [this](const auto& sample) {
    heard_ = Clock::now();
    if (watch_) watch_->see(sample);
  };
  behaviours_.take(see);
  worlds_.take(see);
  if (states_) states_->take(see);
}

void Conductor::show_changes(const Outcome& outcome, std::size_t& shown) const {
  for (; shown < outcome.changes.size(); ++shown) {
    if (listener_.changed) listener_.changed(outcome.changes[shown]);
  }
}

bool Conductor::recorded(const TrialWatch& watch) const {
  if (expect_.count("logger") == 0 || !watch.began()) return true;
  const auto* logger = board_.find({"logger", 0});
  return logger && logger->recorded_trial == watch.outcome().number &&
         logger->recorded_tick >= watch.last_tick();
}

/// The last answers of the trial, and their record: so that whoever stops the stack now loses
/// nothing.
void Conductor::await_record(TrialWatch& watch) {
  const auto since = Clock::now();
  const auto limit = expect_.count("supervisor") == 0 ? kPatience : kRecordLimit;
  const auto complete = [&] {
    if (watch.complete() || Clock::now() - since > limit) return true;
    // Is anybody left to say that it has ended?
    return !watch.outcome().judged || master_gone_ || fault();
  };
  while (Clock::now() - since < kRecordLimit) {
    if (complete() && (recorded(watch) || fault_said(true))) break;
    wait(kPoll);
  }
  if (!watch.complete()) watch.miss(fault().value_or("the last behaviour did not come"));
  if (recorded(watch)) return;
  watch.miss(fault_said(true).value_or("logger/0 has not recorded the last tick"));
}

/// Where no referee has said why, the tick master does.
void Conductor::await_reason(TrialWatch& watch) {
  for (const auto since = Clock::now(); watch.wants_reason(); wait(kPoll)) {
    const auto* report = tick_master_ ? board_.find(*tick_master_) : nullptr;
    if (report == nullptr || Clock::now() - since > kPatience) {
      watch.explain("the tick master does not say why");
    } else if (const auto reason = runtime::reason_in(report->message, watch.outcome().number)) {
      watch.explain(*reason);
    }
  }
}

}  // namespace scarab::experiment
