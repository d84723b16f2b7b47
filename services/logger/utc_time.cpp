#include "services/logger/utc_time.hpp"

#include <array>
#include <ctime>

#include "common/bus/clock.hpp"

namespace scarab::logger {

std::string utc_text(std::int64_t ns_since_epoch) {
  const std::time_t seconds = ns_since_epoch / 1'000'000'000;
  std::tm parts{};
  ::gmtime_r(&seconds, &parts);
  std::array<char, 32> text{};
  const std::size_t size = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return {text.data(), size};
}

std::string utc_now() { return utc_text(bus::now_ns()); }

}  // namespace scarab::logger
