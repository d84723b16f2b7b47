#pragma once

#include <chrono>
#include <optional>

namespace scarab::runtime {

/// Notices when the system clock is set: it then runs otherwise than the steady clock. Stamps of
/// samples before and after such a jump do not compare.
class ClockWatch {
 public:
  /// Far more than time synchronisation slews between two looks, less than anybody would miss.
  static constexpr std::chrono::milliseconds kTolerance{100};

  /// To be called now and then with both clocks' times (ns since their epochs), read together.
  /// Returns by how much the system clock has jumped since the last look, if it has.
  std::optional<std::chrono::nanoseconds> look(std::chrono::nanoseconds system,
                                               std::chrono::nanoseconds steady);

 private:
  std::optional<std::chrono::nanoseconds> offset_;
};

}  // namespace scarab::runtime
