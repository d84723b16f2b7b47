#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "services/robot_bridge/drivers/amosii/protocol/parsers.hpp"
#include "services/robot_bridge/drivers/serial/serial_port.hpp"

namespace scarab::bridge::amosii {

/// How a board is spoken to.
struct Manners {
  serial::Clock::duration reply_timeout{};  ///< from each get on
  unsigned attempts = 1;                    ///< gets before the board is given up
  serial::Clock::duration pause{};          ///< of silence around each set
};

/// What has been said and how often it went wrong.
struct BoardCounters {
  std::uint64_t sets = 0;
  std::uint64_t gets = 0;
  std::uint64_t replies = 0;
  std::uint64_t replies_damaged = 0;  ///< as many bytes as a reply has, but one at most, were none
  std::uint64_t replies_missing = 0;  ///< fewer came in time
};

/// The conversation with a board over its line. Used by one thread.
class Board {
 public:
  /// Opens the line; `counters` outlives the board. Throws DeviceError.
  Board(const std::string& port, const Manners& manners, BoardCounters& counters);

  /// Not answered: that it has arrived is not known. Throws DeviceError.
  void set(const Slots& motors);

  /// Asks until a reply comes that can be one, at most `attempts` times; each takes at most a pause
  /// and a time-out. Throws DeviceError.
  [[nodiscard]] Slots get();

 private:
  [[nodiscard]] std::optional<Slots> reply_until(serial::Deadline deadline);

  serial::SerialPort port_;
  Manners manners_;
  BoardCounters* counters_;
  ReplyParser parser_;
  serial::Deadline busy_until_{};      ///< the line is, with what was said or heard last
  serial::Deadline set_busy_until_{};  ///< the same of the last set
};

}  // namespace scarab::bridge::amosii
