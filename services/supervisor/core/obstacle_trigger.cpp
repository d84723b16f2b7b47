#include "services/supervisor/core/obstacle_trigger.hpp"

#include <algorithm>

namespace scarab::supervisor {
namespace {

bool measures(const Measured& measured, Trigger trigger) {
  switch (trigger) {
    case Trigger::kFrontAngle:
      return measured.front_angle;
    case Trigger::kSupplyCurrent:
      return measured.supply_current;
    case Trigger::kFootForce:
      return measured.foot_force;
    case Trigger::kNone:
      return false;
  }
  return false;
}

}  // namespace

Trigger first_measured(const std::vector<Trigger>& preference, const Measured& measured) {
  const auto found =
      std::find_if(preference.begin(), preference.end(),
                   [&measured](Trigger trigger) { return measures(measured, trigger); });
  return found == preference.end() ? Trigger::kNone : *found;
}

std::string list_of(const std::vector<Trigger>& triggers) {
  std::string text;
  for (const Trigger trigger : triggers) {
    text += (text.empty() ? "" : ", ") + std::string(name(trigger));
  }
  return text;
}

}  // namespace scarab::supervisor
