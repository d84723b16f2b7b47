#pragma once

#include <memory>

#include "services/robot_bridge/core/driver.hpp"

/// The robot's motors when this program crashes: a handler of SIGSEGV, SIGBUS, SIGFPE, SIGILL and
/// SIGABRT (so of std::terminate, too) writes the driver's crash frame to the line, then lets the
/// signal end the process as it would have. What the handler needs is laid down before: it calls
/// only functions that are safe in a signal handler. SIGKILL cannot be caught: then the device's
/// own time-out is what stops it.
namespace scarab::bridge {

/// Longest frame there is room for; activate() throws DeviceError for a longer one.
inline constexpr std::size_t kCrashFrameMost = 1024;

/// Installs the handler, for the rest of the process. Once, before any thread is started.
void install_crash_handler();

/// The driver with its crash frame ready for the handler from before activate() until its motors
/// are confirmed to be off, or it is closed. One at a time in a process.
[[nodiscard]] std::unique_ptr<Driver> with_crash_stop(std::unique_ptr<Driver> driver);

}  // namespace scarab::bridge
