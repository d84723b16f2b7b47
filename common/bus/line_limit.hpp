#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace scarab::bus {

/// Lets so many log lines through in a second and counts the others. Times come from outside, so
/// that it can be tested without waiting.
class LineLimit {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  explicit LineLimit(std::uint32_t lines_a_second) : most_(lines_a_second) {}

  /// Nothing: leave this line out. A number: write it, and say that so many before it were left
  /// out.
  std::optional<std::uint64_t> admit(TimePoint now);

 private:
  std::uint32_t most_;
  TimePoint second_began_{};
  std::uint32_t written_ = 0;
  std::uint64_t left_out_ = 0;
};

}  // namespace scarab::bus
