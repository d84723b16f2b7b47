#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tests/support/programs.hpp"

namespace scarab::test {

/// What a log says of its one trial.
struct TrialLog {
  std::vector<std::uint32_t> ticks;     ///< of robot_state, in the order of the file, none twice
  std::vector<std::int64_t> stamps_ns;  ///< wall clock of each
  unsigned mode_changes = 0;            ///< of behaviour, from mode to mode
};

TrialLog read_trial(const std::filesystem::path& log);

/// True if `ticks` are 0, 1, 2, ...
bool contiguous_from_zero(const std::vector<std::uint32_t>& ticks);

/// `scarab-log diff`: exit code 0 if the chain's samples are equal to the byte.
Finished compare(const std::filesystem::path& a, const std::filesystem::path& b);

/// A copy of a log in which one byte of the n-th sample of `topic` (from 0), `offset` bytes behind
/// its header, is another.
void copy_with_changed_byte(const std::filesystem::path& from, const std::filesystem::path& to,
                            const std::string& topic, std::uint32_t n, std::size_t offset);

}  // namespace scarab::test
