#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "tools/emulator/wire/line_rate.hpp"

namespace scarab::emulator {

/// Bytes under way on one direction of the line, one after the other at its rate. Times are ns of
/// any one clock.
class TimedBytes {
 public:
  explicit TimedBytes(LineRate rate) : rate_(rate) {}

  /// Puts bytes on the line at `from_ns`, or as soon as those before them are through. Returns when
  /// the last one has arrived.
  std::int64_t send(const std::uint8_t* bytes, std::size_t count, std::int64_t from_ns);
  std::int64_t send(const std::vector<std::uint8_t>& bytes, std::int64_t from_ns) {
    return send(bytes.data(), bytes.size(), from_ns);
  }

  struct Arrival {
    std::uint8_t byte = 0;
    std::int64_t time_ns = 0;
  };
  /// The next byte that has arrived by `now_ns`, taken off the line.
  std::optional<Arrival> take(std::int64_t now_ns);

  /// When the last byte of the frame that is under way arrives; none: nothing is under way. So a
  /// frame is worth one wake-up, not one for each byte.
  [[nodiscard]] std::optional<std::int64_t> frame_end_ns() const;

  /// Nothing is under way any more.
  void clear();

 private:
  struct Byte {
    Arrival arrival;
    bool ends_frame = false;
  };

  LineRate rate_;
  std::deque<Byte> under_way_;
  std::int64_t free_ns_ = 0;  // from when on the line is free
};

}  // namespace scarab::emulator
