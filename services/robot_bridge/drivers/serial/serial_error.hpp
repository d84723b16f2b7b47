#pragma once

#include <string>

#include "services/robot_bridge/core/driver.hpp"

namespace scarab::bridge::serial {

/// Why a serial port cannot be used (any more).
enum class Fault {
  kNoDevice,    ///< nothing of that name
  kPermission,  ///< it is there, but not for this user
  kInUse,       ///< another process has it
  kNotSerial,   ///< something else than a serial port
  kSettings,    ///< it takes no such baud rate
  kUnplugged,   ///< it was there and is gone
  kTimedOut,    ///< it took no bytes in time
  kOther,
};

/// what() begins with the port's path and says what to do where that is known.
class SerialError : public DeviceError {
 public:
  SerialError(Fault fault, const std::string& text) : DeviceError(text), fault_(fault) {}
  [[nodiscard]] Fault fault() const { return fault_; }

 private:
  Fault fault_;
};

/// The error of an open() that failed with `error` (errno); `group` owns the device, as far as
/// known.
[[nodiscard]] SerialError open_error(const std::string& path, int error, const std::string& group);

/// The error of a read, write or poll of an open port that failed with `error` (errno).
[[nodiscard]] SerialError use_error(const std::string& path, int error);

[[nodiscard]] SerialError unplugged(const std::string& path);

}  // namespace scarab::bridge::serial
