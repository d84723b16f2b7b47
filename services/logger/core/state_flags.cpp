#include "services/logger/core/state_flags.hpp"

#include "services/logger/core/sample_header.hpp"

namespace scarab::logger {
namespace {

// After the header stand the phase, a 32-bit enumeration whose values beyond the third end a trial
// (idl/scarab/robot_state.idl), and the flag.
constexpr std::size_t kPhase = kStampEnd;
constexpr std::size_t kRealTime = kPhase + 4;
constexpr unsigned kSucceeded = 3;

}  // namespace

std::optional<StateFlags> read_state_flags(const std::uint8_t* cdr, std::size_t size) {
  if (size <= kRealTime || !read_sample_header(cdr, size)) return std::nullopt;
  constexpr std::uint8_t kPlainLittleEndian = 1;
  const std::uint8_t phase = cdr[cdr[1] == kPlainLittleEndian ? kPhase : kPhase + 3];
  return StateFlags{phase >= kSucceeded, cdr[kRealTime] != 0};
}

}  // namespace scarab::logger
