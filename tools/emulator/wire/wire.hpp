#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "tools/emulator/boards/board.hpp"
#include "tools/emulator/faults/effects.hpp"
#include "tools/emulator/wire/byte_noise.hpp"
#include "tools/emulator/wire/pseudo_terminal.hpp"
#include "tools/emulator/wire/timed_bytes.hpp"

namespace scarab::emulator {

/// The serial line between somebody's port and the board: its rate both ways, and what can go wrong
/// with it. Times are ns of the steady clock.
class Wire {
 public:
  /// `baud` 0: no rate at all. Throws what PseudoTerminal throws.
  Wire(const std::filesystem::path& link, unsigned baud, std::uint64_t seed);

  [[nodiscard]] int fd() const { return port_.fd(); }
  [[nodiscard]] bool is_plugged() const { return port_.is_plugged(); }
  /// Lost and flipped bytes, lateness, and the plug.
  void suffer(const Effects& effects);

  /// Takes what somebody has written and hands the board all that has arrived by `now_ns`.
  void carry_in(std::int64_t now_ns, Board& board);
  /// Bytes for the board are under way.
  [[nodiscard]] bool is_carrying_in() const { return in_.frame_end_ns().has_value(); }
  /// Hands somebody the bytes of the board that have arrived by `now_ns`.
  void carry_out(std::int64_t now_ns);
  /// When one of the two has something to do.
  [[nodiscard]] std::optional<std::int64_t> next_ns() const;

 private:
  PseudoTerminal port_;
  TimedBytes in_;
  TimedBytes out_;
  ByteNoise noise_in_;
  ByteNoise noise_out_;
  Effects effects_;
};

}  // namespace scarab::emulator
