#include "services/experiment/line_input.hpp"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "services/experiment/interrupted.hpp"

namespace scarab::experiment {
namespace {

// A signal may end no poll: another thread can be the one that takes it.
constexpr int kLookUpMs = 50;

}  // namespace

std::optional<std::string> LineInput::next() {
  auto end = text_.find('\n');
  while (end == std::string::npos && !ended_) {
    fill();
    end = text_.find('\n');
  }
  if (end == std::string::npos) {
    if (text_.empty()) return std::nullopt;
    return std::exchange(text_, "");
  }
  std::string line = text_.substr(0, end);
  text_.erase(0, end + 1);
  return line;
}

/// Waits for more text or the end.
void LineInput::fill() {
  pollfd input{descriptor_, POLLIN, 0};
  for (int ready = 0; ready <= 0; ready = ::poll(&input, 1, kLookUpMs)) {
    if (interrupted_()) throw Interrupted{};
  }
  std::array<char, 4096> buffer{};
  const ssize_t count = ::read(descriptor_, buffer.data(), buffer.size());
  if (count < 0 && errno != EINTR) {
    throw std::system_error(errno, std::generic_category(), "cannot read trial lines");
  }
  ended_ = count == 0;
  if (count > 0) text_.append(buffer.data(), static_cast<std::size_t>(count));
}

}  // namespace scarab::experiment
