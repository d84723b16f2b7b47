#pragma once

#include "tools/emulator/configuration.hpp"

namespace scarab::emulator {

/// Is a robot at the end of a wire until SIGINT or SIGTERM. Needs a runtime::SignalBlock made
/// before. Throws std::runtime_error if the device cannot be made, bus::Error if the bus cannot be
/// joined.
void emulate(const EmulatorOptions& options, const Configuration& configuration);

}  // namespace scarab::emulator
