#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace scarab::emulator {

/// What happened at the robot's end of the wire, one line an event: `stamp_ns,event,detail`, with
/// the wall clock in ns since the Unix epoch. The file is whole at every moment.
class Journal {
 public:
  /// Without a path nothing is written. Throws std::runtime_error naming the path.
  explicit Journal(const std::filesystem::path& path);

  void note(std::int64_t stamp_ns, std::string_view event, std::string_view detail);
  /// What has been noted is in the file from now on.
  void flush();

 private:
  std::ofstream file_;
};

}  // namespace scarab::emulator
