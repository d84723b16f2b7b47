#pragma once

#include <cstdint>

#include "services/robot_bridge/drivers/dynamixel/protocol/bytes.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/instructions.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/status.hpp"

namespace scarab::emulator {

namespace dxl = bridge::dynamixel;

/// One participant of the bus: an ID, and behind it a control table.
class Device {
 public:
  Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  virtual ~Device() = default;

  [[nodiscard]] virtual std::uint8_t id() const = 0;
  /// Whether it takes part in what happens on the bus (not silenced, not in the middle of a
  /// reboot).
  [[nodiscard]] virtual bool is_awake(std::int64_t now_ns) const = 0;
  [[nodiscard]] virtual dxl::PingAnswer ping() const = 0;
  /// Its status with the data asked for, or with the error that kept it from that.
  [[nodiscard]] virtual dxl::Status read(dxl::Region region) const = 0;
  virtual dxl::StatusError write(std::uint16_t address, dxl::ByteView data) = 0;
  virtual void reboot(std::int64_t now_ns) = 0;

  /// Any instruction has come by on the bus, whomever it was for.
  virtual void hear(std::int64_t now_ns) = 0;
  /// A status of its own without data.
  [[nodiscard]] virtual dxl::Status status(dxl::StatusError error) const = 0;
  /// Which instructions are answered: 0 pings, 1 also reads, 2 all.
  [[nodiscard]] virtual std::int64_t status_return_level() const = 0;
  [[nodiscard]] virtual std::int64_t return_delay_ns() const = 0;
};

}  // namespace scarab::emulator
