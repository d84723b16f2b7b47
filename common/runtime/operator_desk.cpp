#include "common/runtime/operator_desk.hpp"

#include <spdlog/spdlog.h>

#include <utility>

#include "common/bus/clock.hpp"

namespace scarab::runtime {
namespace {

constexpr std::int64_t kOldNs = 5'000'000'000;  // longer than any command is on its way

}  // namespace

bool is_for_tick_master(scarab_OperatorCommand command) { return command <= scarab_OPERATOR_RESET; }

OperatorDesk::Requests OperatorDesk::update() {
  Requests requests;
  reader_.take([&](const scarab_Operator& said) {
    if (!is_for_tick_master(said.command) || !counts(said)) return;
    stamp_ns_ = said.header.stamp_ns;
    const std::string reason = said.reason[0] ? said.reason : "no reason given";
    switch (said.command) {
      case scarab_OPERATOR_START:
        paused_ = false;
        steps_ = 0;
        break;
      case scarab_OPERATOR_PAUSE:
        paused_ = true;
        steps_ = 0;
        break;
      case scarab_OPERATOR_STEP:
        paused_ = true;
        ++steps_;
        break;
      case scarab_OPERATOR_STOP:
        requests.stop = "operator stop: " + reason;
        break;
      case scarab_OPERATOR_EMERGENCY_STOP:
        requests.emergency_stop = "operator emergency stop: " + reason;
        requests.reset = false;  // said before it
        break;
      case scarab_OPERATOR_RESET:
        requests.reset = true;
        break;
      default:
        break;
    }
  });
  return requests;
}

/// A late reader, also one that was cut off for a while, is handed the last word of every living
/// writer, be it minutes old: it must not happen again. An emergency stop is never too old.
bool OperatorDesk::counts(const scarab_Operator& said) {
  const std::int64_t stamp_ns = said.header.stamp_ns;
  if (said.command == scarab_OPERATOR_EMERGENCY_STOP) {
    return std::exchange(emergency_stamp_ns_, stamp_ns) != stamp_ns;
  }
  const std::int64_t now_ns = bus::now_ns();
  const bool clock_set_back = stamp_ns_ > now_ns;
  if (stamp_ns == stamp_ns_ || (stamp_ns < stamp_ns_ && !clock_set_back)) return false;
  if (now_ns - stamp_ns < kOldNs) return true;
  spdlog::warn(
      "an operator's command of {:.1f} s ago is passed over: it is a repetition, or the "
      "clocks of the hosts differ",
      static_cast<double>(now_ns - stamp_ns) * 1e-9);
  return false;
}

void OperatorDesk::tick_started() {
  if (steps_ > 0) --steps_;
}

void OperatorDesk::begin_trial() {
  paused_ = false;
  steps_ = 0;
}

}  // namespace scarab::runtime
