#pragma once

namespace scarab::bridge::serial {

/// Raw 8N1 without flow control at `baud`, any rate the port's hardware can make (not only those
/// with a constant in <termios.h>). A read returns at once with what is there. Returns 0 or an
/// errno; ENOTTY if it is no serial port.
[[nodiscard]] int set_raw(int fd, unsigned baud) noexcept;

/// The rate the port really works at; 0 if it does not tell.
[[nodiscard]] unsigned baud_rate(int fd) noexcept;

/// Whether bytes get across at `made` where `asked` was meant. The kernel takes any rate, and the
/// port's hardware makes the nearest that it can (termios(3): success means that something of what
/// was asked has been done). The last of ten bits may be off by half a bit: 5 % between both ends,
/// half of that for each.
[[nodiscard]] constexpr bool is_near(unsigned made, unsigned asked) noexcept {
  constexpr double kTolerance = 0.025;
  const double off = static_cast<double>(made) - static_cast<double>(asked);
  return (off < 0 ? -off : off) <= kTolerance * asked;
}

/// Nobody else opens the port, and bytes come at once in place of after an adapter's latency timer
/// (16 ms on many). Ports that know neither (pseudo-terminals) are used as they are.
void ask_for_exclusive_use(int fd) noexcept;
void ask_for_low_latency(int fd) noexcept;

/// Throws away what has arrived and was not read.
void flush_input(int fd) noexcept;

}  // namespace scarab::bridge::serial
