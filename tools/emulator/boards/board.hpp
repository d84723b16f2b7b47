#pragma once

#include <bitset>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "common/robot/joints.hpp"
#include "services/plant/core/observation.hpp"
#include "tools/emulator/faults/effects.hpp"

namespace scarab::emulator {

/// One event for the journal: what, and its details in words without a comma.
using Note = std::function<void(std::string_view event, const std::string& detail)>;

/// What a board has its servos do.
struct Drive {
  robot::JointVector target_rad{};  ///< of the joints that have power
  std::bitset<robot::kJointCount> powered;
};

/// Bytes that a board sends in one go.
struct Reply {
  std::vector<std::uint8_t> bytes;
  std::int64_t delay_ns = 0;  ///< after the byte that asked for it, or after the reply before it
};

/// The robot's end of the wire: bytes in, bytes out; a body with sensors and servos behind it. No
/// clock, no file: times are given, ns of any one clock.
class Board {
 public:
  Board() = default;
  Board(const Board&) = delete;
  Board& operator=(const Board&) = delete;
  virtual ~Board() = default;

  /// What it is, one phrase.
  [[nodiscard]] virtual std::string description() const = 0;
  [[nodiscard]] virtual unsigned baud() const = 0;

  /// A byte has arrived; appends what it is answered with.
  virtual void on_byte(std::uint8_t byte, std::int64_t now_ns, std::vector<Reply>& replies) = 0;
  /// Time goes by: what happens by itself (watchdogs).
  virtual void tick(std::int64_t now_ns) = 0;
  /// When tick() has something to do; the largest number there is: never.
  [[nodiscard]] virtual std::int64_t next_tick_ns() const = 0;

  /// What the body's sensors would read now.
  virtual void sense(const plant::Observation& body) = 0;
  /// Faults that are the board's to play: silence, heat, current, tilt.
  virtual void suffer(const Effects& effects) = 0;
  [[nodiscard]] virtual const Drive& drive() const = 0;

  /// How often the host has had a servo powered; grows also where it had power already.
  [[nodiscard]] virtual std::uint64_t power_ups() const = 0;
  /// Somebody has put the robot back to its start and holds it.
  virtual void put_back() = 0;
};

}  // namespace scarab::emulator
