#include "tools/operator/sentence.hpp"

namespace scarab::operator_desk {
namespace {

bool runs(const runtime::ServiceReport& report) {
  return report.lifecycle == scarab_LIFECYCLE_ACTIVE;
}

bool begins_with(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

}  // namespace

std::string sentence(const runtime::ServiceReport& report) {
  std::string state = report.message;
  if (state.empty()) state = runs(report) ? "the trial runs" : "no trial runs";
  const std::string where = report.header.trial == 0
                                ? "no trial yet"
                                : "trial " + std::to_string(report.header.trial) + ", tick " +
                                      std::to_string(report.header.tick);
  return bus::to_string(report.peer) + ": " + state + " (" + where + ")";
}

bool is_paused(const runtime::ServiceReport& report) {
  return runs(report) && begins_with(report.message, "paused");
}

bool shows_effect(const Order& order, const runtime::ServiceReport& before,
                  const runtime::ServiceReport& now) {
  const bool same_trial = now.header.trial == before.header.trial && runs(before);
  switch (order.command) {
    case scarab_OPERATOR_START:
      return !is_paused(now);
    case scarab_OPERATOR_PAUSE:
      return is_paused(now) || !runs(now);
    case scarab_OPERATOR_STEP:
      return !runs(now) || (is_paused(now) &&
                            (!same_trial || now.header.tick >= before.header.tick + order.times));
    case scarab_OPERATOR_STOP:
      return !runs(now);
    case scarab_OPERATOR_EMERGENCY_STOP:
      return begins_with(now.message, "safe stop");
    case scarab_OPERATOR_RESET:
      return !begins_with(now.message, "safe stop");
    default:
      return true;  // the supervisor acknowledges what is done
  }
}

}  // namespace scarab::operator_desk
