#include "tools/drive/stack.hpp"

#include <algorithm>
#include <vector>

#include "common/bus/clock.hpp"
#include "common/bus/sample_fields.hpp"
#include "common/runtime/operator_desk.hpp"
#include "common/runtime/peers.hpp"
#include "common/runtime/status_publisher.hpp"
#include "services/supervisor/adapter.hpp"
#include "tools/drive/adapter.hpp"

namespace scarab::drive {
namespace {

constexpr std::chrono::seconds kAnswerLimit{3};
constexpr std::chrono::seconds kRateSpan{1};
constexpr std::chrono::seconds kStartLimit{2};

bus::ReaderOptions view() {
  bus::ReaderOptions options;
  options.best_effort = true;
  options.depth = 1;
  return options;
}

}  // namespace

Stack::Stack(const runtime::BusOptions& options)
    : participant_(options.participant("drive", 0)),
      states_(participant_, bus::kRobotState, view()),
      behaviours_(participant_, bus::kBehaviour, view()),
      board_(participant_),
      orders_(participant_, bus::kOperator),
      trials_(participant_, bus::kTrial),
      guard_(participant_),
      wait_set_(participant_),
      shutdown_(guard_) {
  wait_set_.attach(guard_);
  live_.where = "domain " + std::to_string(options.domain) +
                (options.tag.empty() ? "" : " tag " + options.tag);
}

bool Stack::wait(std::chrono::nanoseconds limit) {
  wait_set_.wait(limit);
  if (shutdown_.requested()) return false;
  states_.take([this](const scarab_RobotState& state) { see(live_, state); });
  behaviours_.take([this](const scarab_Behaviour& behaviour) { see(live_, behaviour); });
  board_.update();
  const auto master = tick_master();
  see(live_, board_.reports(), master ? bus::to_string(*master) : "");
  measure_rate();
  return true;
}

std::optional<bus::Peer> Stack::tick_master() const {
  const auto writers = states_.matched();
  if (writers.empty()) return std::nullopt;
  return writers.front();
}

void Stack::measure_rate() {
  const auto now = Clock::now();
  if (live_.trial != rate_trial_ || !live_.trial_runs) {
    live_.ticks_per_s = 0;
  } else if (now - rate_since_ < kRateSpan) {
    return;
  } else {
    live_.ticks_per_s =
        (live_.tick - rate_tick_) / std::chrono::duration<double>(now - rate_since_).count();
  }
  rate_trial_ = live_.trial;
  rate_tick_ = live_.tick;
  rate_since_ = now;
}

void Stack::say(const Order& order) {
  scarab_Operator said{};
  said.header.trial = live_.trial;
  last_stamp_ns_ = said.header.stamp_ns = std::max(bus::now_ns(), last_stamp_ns_ + 1);
  if (!runtime::is_for_tick_master(order.command)) supervisor::fill(said, order.word);
  said.command = order.command;
  bus::assign(said.reason, "by hand in scarab-drive");
  orders_.write(said);
  open_ = {order, last_stamp_ns_, Clock::now()};
}

const runtime::ServiceReport* Stack::acknowledging() const {
  for (const auto& [peer, report] : board_.reports()) {
    const auto counter = report.counters.find(runtime::kOperatorStamp);
    if (counter == report.counters.end()) continue;
    if (counter->second == static_cast<std::uint64_t>(open_->stamp_ns)) return &report;
  }
  return nullptr;
}

std::optional<Notice> Stack::news_of_order() {
  if (!open_) return std::nullopt;
  if (const auto* report = acknowledging(); report != nullptr) {
    const bool refused =
        !runtime::is_for_tick_master(open_->order.command) && report->health != scarab_HEALTH_OK;
    const std::string says = report->message.empty() ? "done" : report->message;
    const Notice notice{open_->order.name + ": " + bus::to_string(report->peer) + ": " + says,
                        refused ? Concern::kDegraded : Concern::kNone};
    open_.reset();
    return notice;
  }
  if (Clock::now() - open_->since < kAnswerLimit) return std::nullopt;
  const bool paused = live_.trial_runs && live_.tick_master_says.compare(0, 6, "paused") == 0;
  const std::string name = open_->order.name;
  open_.reset();
  if (paused) return Notice{name + ": counts from the next tick", Concern::kWaits};
  return Notice{name + ": nobody has acknowledged it", Concern::kFault};
}

std::string Stack::missing_for_trial() const {
  std::vector<std::string> missing;
  const auto master = tick_master();
  if (!master || board_.find(*master) == nullptr) missing.emplace_back("a tick master");
  for (const char* service : {"supervisor", "premotor"}) {
    const auto& reports = board_.reports();
    const bool there = std::any_of(reports.begin(), reports.end(), [&](const auto& entry) {
      return entry.first.service == service;
    });
    if (!there) missing.emplace_back(service);
  }
  return runtime::join(missing);
}

std::uint32_t Stack::tell_trial(const runtime::TrialOptions& options) {
  std::uint32_t newest = live_.trial;
  for (const auto& [peer, report] : board_.reports()) {
    newest = std::max({newest, report.header.trial, report.ready_trial, report.recorded_trial});
  }
  own_trial_ = newest + 1;
  scarab_Trial trial = runtime::make_trial(options, 0, own_trial_);
  trial.header.stamp_ns = bus::now_ns();
  trials_.write(trial);
  told_ = Clock::now();
  return own_trial_;
}

bool Stack::trial_is_starting() const {
  return own_trial_ > live_.trial && Clock::now() - told_ < kStartLimit;
}

bool Stack::runs_own_trial() const {
  return own_trial_ != 0 && live_.trial_runs && live_.trial == own_trial_;
}

}  // namespace scarab::drive
