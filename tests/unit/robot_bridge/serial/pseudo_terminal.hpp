#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace scarab::test {

using Bytes = std::vector<std::uint8_t>;

/// A serial line without hardware: the program under test opens path(), the test is the device at
/// its other end. Throws std::system_error.
class PseudoTerminal {
 public:
  PseudoTerminal();
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

  void write(const Bytes& bytes);
  /// The next `size` bytes, or those that came within `within`.
  Bytes read(std::size_t size, std::chrono::milliseconds within = std::chrono::seconds(5));
  /// Pulls the plug: the device is gone for whoever has it open.
  void unplug();

 private:
  int master_ = -1;
  std::string path_;
};

}  // namespace scarab::test
