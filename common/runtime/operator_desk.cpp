#include "common/runtime/operator_desk.hpp"

namespace scarab::runtime {

bool is_for_tick_master(scarab_OperatorCommand command) { return command <= scarab_OPERATOR_RESET; }

OperatorDesk::Requests OperatorDesk::update() {
  Requests requests;
  reader_.take([&](const scarab_Operator& said) {
    if (!is_for_tick_master(said.command)) return;
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

void OperatorDesk::tick_started() {
  if (steps_ > 0) --steps_;
}

void OperatorDesk::begin_trial() {
  paused_ = false;
  steps_ = 0;
}

}  // namespace scarab::runtime
