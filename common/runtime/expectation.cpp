#include "common/runtime/expectation.hpp"

#include <charconv>
#include <stdexcept>

namespace scarab::runtime {
namespace {

constexpr std::uint32_t kMaxInstances = 16;

[[noreturn]] void refuse(std::string_view part, const std::string& reason) {
  throw std::invalid_argument("'" + std::string(part) + "': " + reason);
}

void add_part(Expectation& expectation, std::string_view part) {
  const auto equals = part.find('=');
  if (equals == std::string_view::npos || equals == 0) refuse(part, "expected NAME=COUNT");
  const std::string name(part.substr(0, equals));
  const std::string_view digits = part.substr(equals + 1);
  std::uint32_t count = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
  if (error != std::errc{} || end != digits.data() + digits.size() || count > kMaxInstances) {
    refuse(part, "the count must be a whole number from 0 to " + std::to_string(kMaxInstances));
  }
  if (!expectation.emplace(name, count).second) refuse(part, "named twice");
}

}  // namespace

Expectation parse_expectation(std::string_view text) {
  Expectation expectation;
  while (!text.empty()) {
    const auto comma = text.find(',');
    add_part(expectation, text.substr(0, comma));
    text = comma == std::string_view::npos ? std::string_view{} : text.substr(comma + 1);
  }
  return expectation;
}

}  // namespace scarab::runtime
