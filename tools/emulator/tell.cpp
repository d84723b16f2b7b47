#include "tools/emulator/tell.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "tools/emulator/faults/fault_text.hpp"

namespace scarab::emulator {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + word;
  return line;
}

}  // namespace

void check_order(const std::vector<std::string>& words) {
  try {
    (void)parse_fault_order(joined(words));
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError("tell", error.what());
  }
}

void tell(const std::filesystem::path& where, const std::vector<std::string>& words) {
  const std::filesystem::path pipe =
      std::filesystem::is_directory(where) ? where / kControlPipeName : where;
  if (!std::filesystem::is_fifo(pipe)) {
    throw std::runtime_error("no emulator listens at " + pipe.string());
  }
  const int fd = ::open(pipe.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
  if (fd < 0) {
    throw std::runtime_error(errno == ENXIO ? "no emulator listens at " + pipe.string()
                                            : pipe.string() + ": " + std::strerror(errno));
  }
  const std::string text = joined(words) + "\n";  // shorter than PIPE_BUF: all of it or nothing
  const ssize_t count = ::write(fd, text.data(), text.size());
  const int error = errno;
  ::close(fd);
  if (count != static_cast<ssize_t>(text.size())) {
    throw std::runtime_error(pipe.string() + ": " + std::strerror(error));
  }
}

}  // namespace scarab::emulator
