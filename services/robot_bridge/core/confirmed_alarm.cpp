#include "services/robot_bridge/core/confirmed_alarm.hpp"

namespace scarab::bridge {

void ConfirmedAlarm::observe(Level level, const std::string& reason) {
  const Level other = raised_ ? Level::kWithin : Level::kBeyond;
  against_ = level == other ? against_ + 1 : 0;
  if (against_ < confirm_readings_) return;
  against_ = 0;
  raised_ = !raised_;
  reason_ = raised_ ? reason : "";
}

}  // namespace scarab::bridge
