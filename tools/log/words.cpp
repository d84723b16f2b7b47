#include "tools/log/words.hpp"

#include <ctime>
#include <iomanip>
#include <sstream>

namespace scarab::log {

std::string utc_text(std::uint64_t time_ns) {
  const auto seconds = static_cast<std::time_t>(time_ns / 1'000'000'000U);
  std::tm parts{};
  ::gmtime_r(&seconds, &parts);
  std::ostringstream text;
  text << std::put_time(&parts, "%Y-%m-%d %H:%M:%S") << '.' << std::setfill('0') << std::setw(3)
       << time_ns / 1'000'000U % 1000U << " UTC";
  return text.str();
}

std::string size_text(std::uint64_t bytes) {
  constexpr double kKilo = 1e3;
  constexpr double kMega = 1e6;
  const auto size = static_cast<double>(bytes);
  if (size < kKilo) return std::to_string(bytes) + " B";
  return size < kMega ? fixed_text(size / kKilo, 1) + " kB" : fixed_text(size / kMega, 1) + " MB";
}

std::string counted(std::uint64_t number, const std::string& noun) {
  return std::to_string(number) + " " + noun + (number == 1 ? "" : "s");
}

std::string fixed_text(double value, int digits) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

}  // namespace scarab::log
