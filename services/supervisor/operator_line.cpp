#include "services/supervisor/operator_line.hpp"

#include <algorithm>

#include "common/bus/clock.hpp"
#include "services/supervisor/adapter.hpp"

namespace scarab::supervisor {
namespace {

// A late joiner, such as this process after a restart, is given the last word of every writer that
// lives, be it minutes old.
constexpr std::int64_t kOldNs = 5'000'000'000;  // longer than any word is on its way

bool is_fresh(const scarab_Operator& said) { return bus::now_ns() - said.header.stamp_ns < kOldNs; }

/// Neither the last word again nor one from before it. Where the clock has been set back since the
/// last word, the two do not compare.
bool is_news(const scarab_Operator& said, std::int64_t heard_ns) {
  const std::int64_t stamp_ns = said.header.stamp_ns;
  return stamp_ns != heard_ns && (stamp_ns > heard_ns || heard_ns > bus::now_ns());
}

}  // namespace

void OperatorLine::begin(std::uint32_t trial) {
  take();
  trial_ = trial;
  const auto is_older = [trial](const scarab_Operator& said) { return said.header.trial != trial; };
  waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(), is_older), waiting_.end());
}

void OperatorLine::take() {
  reader_.take([this](const scarab_Operator& said) {
    if (to_word(said) && is_fresh(said)) waiting_.push_back(said);
  });
}

void OperatorLine::tell(const BehaviourMachine& machine, MachineState& state, std::uint32_t tick,
                        std::int64_t& heard_ns) {
  take();
  for (const auto& said : waiting_) {
    const bool is_of_another_trial = said.header.trial != 0 && said.header.trial != trial_;
    if (is_of_another_trial || !is_news(said, heard_ns)) continue;
    heard_ns = said.header.stamp_ns;
    refused_ = machine.tell(state, *to_word(said), tick);
    if (!refused_.empty()) refused_ = "operator's word refused: " + refused_;
  }
  waiting_.clear();
}

void OperatorLine::acknowledge(const MachineState& state, std::int64_t heard_ns) {
  if (heard_ns == 0 || heard_ns == acknowledged_ns_) return;
  acknowledged_ns_ = heard_ns;
  message_ = refused_.empty() ? standing(state) : refused_;
  changed_ = true;
}

void OperatorLine::report(runtime::StatusPublisher& status) {
  take();
  if (trial_ == 0) {
    for (const auto& said : waiting_) {
      if (!is_news(said, acknowledged_ns_)) continue;
      acknowledged_ns_ = said.header.stamp_ns;
      refused_ = message_ = "operator's word refused: no trial runs";
      changed_ = true;
    }
    waiting_.clear();
  }
  if (!changed_) return;
  changed_ = false;
  status.set_counter(runtime::kOperatorStamp, static_cast<std::uint64_t>(acknowledged_ns_));
  status.set_health(refused_.empty() ? scarab_HEALTH_OK : scarab_HEALTH_DEGRADED, message_);
}

}  // namespace scarab::supervisor
