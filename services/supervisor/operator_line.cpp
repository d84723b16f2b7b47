#include "services/supervisor/operator_line.hpp"

#include <algorithm>

#include "services/supervisor/adapter.hpp"

namespace scarab::supervisor {

void OperatorLine::begin(std::uint32_t trial) {
  take();
  trial_ = trial;
  const auto is_older = [trial](const scarab_Operator& said) { return said.header.trial != trial; };
  waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(), is_older), waiting_.end());
}

void OperatorLine::take() {
  reader_.take([this](const scarab_Operator& said) {
    if (to_word(said)) waiting_.push_back(said);
  });
}

void OperatorLine::tell(const BehaviourMachine& machine, MachineState& state, std::uint32_t tick,
                        std::int64_t& heard_ns) {
  take();
  for (const auto& said : waiting_) {
    const bool is_of_another_trial = said.header.trial != 0 && said.header.trial != trial_;
    if (is_of_another_trial || said.header.stamp_ns == heard_ns) continue;
    heard_ns = said.header.stamp_ns;
    refused_ = machine.tell(state, *to_word(said), tick);
    if (!refused_.empty()) refused_ = "operator's word refused: " + refused_;
  }
  waiting_.clear();
}

void OperatorLine::acknowledge(const MachineState& state, std::int64_t heard_ns) {
  if (heard_ns == acknowledged_ns_) return;
  acknowledged_ns_ = heard_ns;
  message_ = refused_.empty() ? standing(state) : refused_;
  changed_ = true;
}

void OperatorLine::report(runtime::StatusPublisher& status) {
  if (trial_ == 0) {
    take();
    for (const auto& said : waiting_) {
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
