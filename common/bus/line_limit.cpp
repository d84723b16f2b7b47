#include "common/bus/line_limit.hpp"

#include <utility>

namespace scarab::bus {

std::optional<std::uint64_t> LineLimit::admit(TimePoint now) {
  if (now - second_began_ >= std::chrono::seconds(1)) {
    second_began_ = now;
    written_ = 0;
  }
  if (written_ == most_) {
    ++left_out_;
    return std::nullopt;
  }
  ++written_;
  return std::exchange(left_out_, 0);
}

}  // namespace scarab::bus
