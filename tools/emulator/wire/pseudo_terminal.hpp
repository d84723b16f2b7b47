#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tools/emulator/wire/link.hpp"

namespace scarab::emulator {

/// A serial port for somebody else to open: a pseudo-terminal behind a link of a steady name.
class PseudoTerminal {
 public:
  /// Plugged in at once. Throws std::runtime_error if there is no pseudo-terminal, and what Link
  /// throws.
  explicit PseudoTerminal(const std::filesystem::path& link);
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  /// Takes the device away: who has it open sees it hung up, who opens it finds nothing.
  void unplug() noexcept;
  /// A new one behind the same link.
  void plug();
  [[nodiscard]] bool is_plugged() const { return board_side_ >= 0; }

  /// What ppoll() waits on; -1 while unplugged.
  [[nodiscard]] int fd() const { return board_side_; }
  [[nodiscard]] const std::filesystem::path& link() const { return link_.path(); }

  /// The bytes that have been written by the other side; empty: none, or unplugged.
  [[nodiscard]] std::vector<std::uint8_t> read();
  /// Bytes for the other side. What nobody reads is lost once the line's buffer is full, as on a
  /// UART. Returns how many were taken.
  std::size_t write(const std::vector<std::uint8_t>& bytes);

 private:
  Link link_;
  int board_side_ = -1;
  // Kept open: the line is then there whether or not somebody has opened it, and poll() is quiet.
  int port_side_ = -1;
};

}  // namespace scarab::emulator
