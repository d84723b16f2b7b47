#include "tools/operator/exchange.hpp"

#include <algorithm>

#include "common/bus/clock.hpp"
#include "common/bus/sample_fields.hpp"
#include "common/runtime/operator_desk.hpp"
#include "common/runtime/status_publisher.hpp"
#include "services/supervisor/adapter.hpp"

namespace scarab::operator_desk {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPoll{5};

bus::ReaderOptions only_the_writers() {
  bus::ReaderOptions options;
  options.best_effort = true;
  options.depth = 1;
  return options;
}

}  // namespace

Exchange::Exchange(const runtime::BusOptions& options)
    : participant_(options.participant("operator", 0)),
      writer_(participant_, bus::kOperator),
      states_(participant_, bus::kRobotState, only_the_writers()),
      board_(participant_),
      guard_(participant_),
      wait_set_(participant_),
      shutdown_(guard_) {
  wait_set_.attach(board_.reader());
  wait_set_.attach(guard_);
}

bool Exchange::wait_until(const std::function<bool()>& condition, std::chrono::milliseconds limit) {
  const auto since = Clock::now();
  for (;;) {
    board_.update();
    if (condition()) return true;
    if (Clock::now() - since > limit) return false;
    wait_set_.wait(kPoll);
    if (shutdown_.requested()) throw Interrupted{};
  }
}

std::optional<bus::Peer> Exchange::tick_master() const {
  const auto writers = states_.matched();
  if (writers.empty()) return std::nullopt;
  return writers.front();
}

std::optional<bus::Peer> Exchange::find_listener(bool tick_master,
                                                 std::chrono::milliseconds limit) {
  std::optional<bus::Peer> found;
  wait_until(
      [&] {
        const auto readers = writer_.matched();
        const auto master = this->tick_master();
        const auto is_wanted = [&](const bus::Peer& peer) {
          return tick_master ? master == peer : peer.service == "supervisor";
        };
        const auto peer = std::find_if(readers.begin(), readers.end(), is_wanted);
        if (peer != readers.end()) found = *peer;
        return found.has_value();
      },
      limit);
  return found;
}

std::optional<Exchange::Report> Exchange::await_report(const bus::Peer& peer,
                                                       std::chrono::milliseconds limit) {
  if (!wait_until([&] { return board_.find(peer) != nullptr; }, limit)) return std::nullopt;
  return *board_.find(peer);
}

void Exchange::say(const Order& order, std::uint32_t trial) {
  scarab_Operator said{};
  said.header.trial = trial;
  if (!runtime::is_for_tick_master(order.command)) supervisor::fill(said, order.word);
  said.command = order.command;
  bus::assign_truncated(said.reason, order.reason);
  for (unsigned i = 0; i < order.times; ++i) {
    said.header.stamp_ns = stamp_ns_ = std::max(bus::now_ns(), stamp_ns_ + 1);
    writer_.write(said);
  }
}

const Exchange::Report* Exchange::acknowledging() const {
  for (const auto& [peer, report] : board_.reports()) {
    const auto counter = report.counters.find(runtime::kOperatorStamp);
    if (counter == report.counters.end()) continue;
    if (counter->second == static_cast<std::uint64_t>(stamp_ns_)) return &report;
  }
  return nullptr;
}

std::optional<bus::Peer> Exchange::await_acknowledgement(const std::function<bool()>& gives_up,
                                                         std::chrono::milliseconds limit) {
  const Report* answer = nullptr;
  wait_until(
      [&] {
        answer = acknowledging();
        return answer != nullptr || gives_up();
      },
      limit);
  if (answer == nullptr) return std::nullopt;
  return answer->peer;
}

std::optional<Exchange::Report> Exchange::await_effect(
    const bus::Peer& peer, const std::function<bool(const Report&)>& shows,
    std::chrono::milliseconds limit) {
  wait_until(
      [&] {
        const Report* now = board_.find(peer);
        return now != nullptr && shows(*now);
      },
      limit);
  const Report* now = board_.find(peer);
  if (now == nullptr) return std::nullopt;
  return *now;
}

}  // namespace scarab::operator_desk
