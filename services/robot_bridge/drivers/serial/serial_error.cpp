#include "services/robot_bridge/drivers/serial/serial_error.hpp"

#include <cerrno>
#include <system_error>

namespace scarab::bridge::serial {
namespace {

std::string text_of(int error) { return std::system_category().message(error); }

}  // namespace

SerialError open_error(const std::string& path, int error, const std::string& group) {
  switch (error) {
    case ENOENT:
    case ENODEV:
    case ENXIO:
    case ENOTDIR:
      return {Fault::kNoDevice, path + ": no such device"};
    case EACCES:
    case EPERM:
      return {Fault::kPermission, path + ": permission denied: add yourself to the group " +
                                      (group.empty() ? "dialout" : group) + " and log in again"};
    case EBUSY:
    case EWOULDBLOCK:
      return {Fault::kInUse, path + ": in use by another process"};
    case ENOTTY:
    case EISDIR:
      return {Fault::kNotSerial, path + ": is no serial port"};
    case EIO:
      return unplugged(path);
    default:
      return {Fault::kOther, path + ": cannot be opened: " + text_of(error)};
  }
}

SerialError use_error(const std::string& path, int error) {
  // What the drivers of USB adapters and pseudo-terminals answer when the other end has gone.
  if (error == EIO || error == ENODEV || error == ENXIO || error == EPIPE) return unplugged(path);
  return {Fault::kOther, path + ": " + text_of(error)};
}

SerialError unplugged(const std::string& path) { return {Fault::kUnplugged, path + ": unplugged"}; }

}  // namespace scarab::bridge::serial
