#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scarab::emulator {

/// Throws CLI::ValidationError if the words are no order.
void check_order(const std::vector<std::string>& words);

/// Writes an order into a running emulator's control pipe; `where` is the pipe or the run directory
/// it is in. Throws std::runtime_error if nobody listens there.
void tell(const std::filesystem::path& where, const std::vector<std::string>& words);

/// The name of the control pipe in a run directory.
inline constexpr const char* kControlPipeName = "emulator";

}  // namespace scarab::emulator
