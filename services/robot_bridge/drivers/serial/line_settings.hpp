#pragma once

namespace scarab::bridge::serial {

/// Raw 8N1 without flow control at `baud`, any rate the port's hardware can make (not only those
/// with a constant in <termios.h>). A read returns at once with what is there. Returns 0 or an
/// errno; ENOTTY if it is no serial port.
[[nodiscard]] int set_raw(int fd, unsigned baud) noexcept;

/// The rate the port really works at; 0 if it does not tell.
[[nodiscard]] unsigned baud_rate(int fd) noexcept;

/// Nobody else opens the port, and bytes come at once in place of after an adapter's latency timer
/// (16 ms on many). Ports that know neither (pseudo-terminals) are used as they are.
void ask_for_exclusive_use(int fd) noexcept;
void ask_for_low_latency(int fd) noexcept;

/// Throws away what has arrived and was not read.
void flush_input(int fd) noexcept;

}  // namespace scarab::bridge::serial
