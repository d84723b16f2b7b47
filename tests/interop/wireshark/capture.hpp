#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/child_process.hpp"

namespace scarab::test {

/// What tshark makes of the packets of one DDS domain on the loopback interface.
class Capture {
 public:
  /// Captures from now on, into `file`. Throws std::runtime_error if it may not.
  Capture(std::uint32_t domain, const std::filesystem::path& file);

  /// Ends it. Throws std::runtime_error if tshark does not end well.
  void stop();

  /// The dissected packets that pass a display filter, a line each: these fields, between tabs.
  [[nodiscard]] std::vector<std::string> dissect(const std::string& filter,
                                                 const std::vector<std::string>& fields) const;

 private:
  std::filesystem::path file_;
  ChildProcess tshark_;
};

}  // namespace scarab::test
