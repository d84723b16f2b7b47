#pragma once

#include <string>

namespace scarab::bridge {

/// How one reading stands to its limit. Between the limit and the level at which it counts as kept
/// again, it neither raises nor clears.
enum class Level { kWithin, kBetween, kBeyond };

/// An alarm that takes some readings in a row to be raised, and as many to be cleared.
class ConfirmedAlarm {
 public:
  explicit ConfirmedAlarm(unsigned confirm_readings) : confirm_readings_(confirm_readings) {}

  /// `reason`: what is said if this reading raises the alarm.
  void observe(Level level, const std::string& reason);

  [[nodiscard]] bool raised() const { return raised_; }
  /// Of the reading that raised it.
  [[nodiscard]] const std::string& reason() const { return reason_; }

 private:
  unsigned confirm_readings_;
  unsigned against_ = 0;  ///< readings in a row that speak against how it stands
  bool raised_ = false;
  std::string reason_;
};

}  // namespace scarab::bridge
