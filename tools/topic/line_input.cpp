#include "tools/topic/line_input.hpp"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "common/runtime/program.hpp"
#include "tools/topic/failure.hpp"

namespace scarab::topic {

bool read_lines(const std::function<bool()>& interrupted,
                const std::function<bool(const std::string&)>& f) {
  constexpr int kPatienceMs = 50;  // until Ctrl-C is looked for again
  std::array<char, 65536> buffer;
  std::string pending;
  while (!interrupted()) {
    pollfd in{STDIN_FILENO, POLLIN, 0};
    if (::poll(&in, 1, kPatienceMs) <= 0) continue;
    const ssize_t size = ::read(STDIN_FILENO, buffer.data(), buffer.size());
    if (size < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (size <= 0) {
      if (!pending.empty()) f(pending);
      return true;
    }
    pending.append(buffer.data(), static_cast<std::size_t>(size));
    std::size_t begin = 0;
    for (std::size_t end = 0; (end = pending.find('\n', begin)) != std::string::npos;
         begin = end + 1) {
      if (interrupted() || !f(pending.substr(begin, end - begin))) return false;
    }
    pending.erase(0, begin);
  }
  return false;
}

std::string read_whole(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  const int error = in ? 0 : errno;
  // A directory can be opened, and has nothing to read.
  const bool is_directory = in && std::filesystem::is_directory(file);
  if (error != 0 || is_directory) {
    throw Failure(runtime::kExitBadUsage,
                  "cannot read " + file + ": " + std::strerror(is_directory ? EISDIR : error));
  }
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

}  // namespace scarab::topic
