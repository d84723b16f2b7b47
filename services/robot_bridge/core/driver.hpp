#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "common/robot/joints.hpp"
#include "services/robot_bridge/core/readings.hpp"

namespace scarab::bridge {

/// The device is lost, or answers nonsense beyond the retries. what() is one line that says which
/// device (the port, the joint or board) and what it did.
class DeviceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a device can do: for messages, and for what is safe to promise.
struct Capabilities {
  bool position_feedback = false;
  bool velocity_feedback = false;
  bool torque_feedback = false;  ///< measured, or from a measured current
  bool foot_force = false;
  bool imu = false;             ///< at least roll and pitch
  bool temperature = false;     ///< of each joint
  bool joint_current = false;   ///< of each joint
  bool supply_current = false;  ///< of the whole robot
  bool torque_switch = false;   ///< release() really takes the torque away
  /// The device goes into its own safe state after so long without a word from the bridge; none: it
  /// holds its last goals for ever.
  std::optional<double> device_timeout_s;
  /// The line it is reached by and how, one phrase: "/dev/ttyUSB0 at 1000000 baud".
  std::string link;
};

/// Bytes that switch the motors off, and where to write them.
struct CrashFrame {
  int fd = -1;
  std::vector<std::uint8_t> bytes;
};

/// One robot's device: its servos and sensors behind one line. Everything else of the bridge knows
/// a robot by this interface only. Used by one thread.
///
/// Order of calls: open(); read() any number of times, motors off; activate(); read() and write()
/// in turn; hold() or release(); close(). After a DeviceError of any call the bridge tries hold()
/// or release() if motors may be on, then close(), and open() again later.
class Driver {
 public:
  Driver() = default;
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;
  /// Motors off if they were on.
  virtual ~Driver() = default;

  /// Opens the line, finds every device and switches the motors off. Throws DeviceError; then it is
  /// closed again.
  virtual void open() = 0;
  /// Says nothing more to the device: motors that are on are left to its own time-out.
  virtual void close() noexcept = 0;

  /// One exchange, bounded in time; retries are counted. Throws DeviceError.
  virtual Readings read() = 0;

  /// Goals become `hold_rad`, the device's own time-out is armed, then torque on: no joint moves
  /// but to `hold_rad`. Throws DeviceError; the caller then calls release().
  virtual void activate(const robot::JointVector& hold_rad) = 0;
  /// Goals of all joints, finite; absent joints' are ignored. What lies beyond a servo's range is
  /// told as its end. Throws DeviceError.
  virtual void write(const robot::JointVector& target_rad) = 0;

  /// Safe stop with torque: no motion any more. Bounded. False: the device did not confirm it.
  virtual bool hold() noexcept = 0;
  /// Safe stop without torque. Bounded. False: the device did not confirm it, or has no switch.
  virtual bool release() noexcept = 0;

  [[nodiscard]] virtual Capabilities capabilities() const = 0;
  /// What has been counted since the program started (frames, retries, errors by kind), by names of
  /// at most 47 characters; at most 40, which service_status has room for.
  [[nodiscard]] virtual std::vector<std::pair<std::string, std::uint64_t>> counters() const = 0;
  /// What a signal handler writes while the process dies; asked for before each activate(). None if
  /// the device cannot switch its motors off.
  [[nodiscard]] virtual std::optional<CrashFrame> crash_frame() const { return std::nullopt; }
};

}  // namespace scarab::bridge
