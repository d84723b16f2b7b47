#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>

#include "services/robot_bridge/drivers/amosii/protocol/frames.hpp"

/// Streams of bytes to frames, one byte at a time. A frame is known by its own bytes, looking back
/// from its terminator: whatever came before it, an undamaged frame is found as soon as its last
/// byte arrives. Nothing is allocated, no state is kept but the newest bytes.
namespace scarab::bridge::amosii {

/// The newest bytes of a stream since the last frame.
template <std::size_t kSize>
class Window {
 public:
  void push(std::uint8_t byte) {
    bytes_[next_] = byte;
    next_ = (next_ + 1) % kSize;
    if (count_ < kSize) ++count_;
  }
  void clear() { count_ = 0; }
  [[nodiscard]] std::size_t count() const { return count_; }
  /// The byte that came `age` bytes before the newest; `age` below count().
  [[nodiscard]] std::uint8_t back(std::size_t age) const {
    return bytes_[(next_ + 2 * kSize - 1 - age) % kSize];
  }
  /// The slots of a frame whose terminator is the newest byte; count() above kSlotCount.
  [[nodiscard]] Slots slots() const {
    Slots slots;
    for (std::size_t i = 0; i < kSlotCount; ++i) slots.bytes[i] = back(kSlotCount - i);
    return slots;
  }

 private:
  std::array<std::uint8_t, kSize> bytes_{};
  std::size_t next_ = 0;
  std::size_t count_ = 0;
};

/// The board's side: what the host commands. Bytes that belong to no frame are passed over, so a
/// get may be followed by anything (the laboratory's own software sends 98 undefined bytes behind
/// it; where these hold a 02 00 that is a second get, and nobody can tell). Whether the board
/// itself checks as much as this parser does is not published.
class CommandParser {
 public:
  struct Get {};
  using Command = std::variant<Slots, Get>;

  /// The command that `byte` completes.
  std::optional<Command> push(std::uint8_t byte);

  /// Sets that ended at their place but fail the checks of is_plausible_set().
  [[nodiscard]] std::uint64_t implausible_sets() const { return implausible_sets_; }

 private:
  Window<std::tuple_size_v<SetFrame>> window_;
  std::uint64_t implausible_sets_ = 0;
};

/// The host's side: what the board answers. Undamaged replies without a 0 are always found; one
/// with a 0 at an input that may read it, only as long as the stream is in step. So expect() before
/// each get.
class ReplyParser {
 public:
  /// The reply that `byte` completes.
  std::optional<Slots> push(std::uint8_t byte);

  /// The next byte is a reply's first.
  void expect();
  /// Bytes since expect() or the last reply.
  [[nodiscard]] std::size_t pending() const { return pending_; }

 private:
  Window<std::tuple_size_v<ReplyFrame>> window_;
  std::size_t pending_ = 0;
};

}  // namespace scarab::bridge::amosii
