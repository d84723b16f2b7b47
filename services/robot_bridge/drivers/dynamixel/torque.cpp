#include "services/robot_bridge/drivers/dynamixel/torque.hpp"

#include <string>

namespace scarab::bridge::dynamixel {
namespace {

constexpr std::int64_t kOn = 1;
constexpr std::int64_t kOff = 0;
constexpr int kTries = 3;  // a sync write is not answered, and may be lost

/// What the hardware error status of a servo says, " (overload)", or nothing.
std::string hardware_error(ServoGroup& servos, std::size_t index) {
  const auto bits = servos.read_one(index, &ServoModel::hardware_error_status);
  return bits == 0 ? "" : " (" + hardware_error_text(static_cast<std::uint8_t>(bits)) + ")";
}

/// Until it reads back as written.
void write_surely(ServoGroup& servos, ItemOf item, const Counts& counts, const std::string& what) {
  Counts taken;
  for (int i = 0; i < kTries && taken != counts; ++i) {
    servos.write(item, counts);
    taken = servos.read(item);
  }
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (taken[i] == counts[i]) continue;
    throw DeviceError(servos.bus().path() + ": " + servos.name_of(i) + " does not take " + what +
                      " " + std::to_string(counts[i]) + ", it has " + std::to_string(taken[i]) +
                      hardware_error(servos, i));
  }
}

void write_surely(ServoGroup& servos, ItemOf item, std::int64_t count, const std::string& what) {
  write_surely(servos, item, Counts(servos.size(), count), what);
}

}  // namespace

void switch_on(ServoGroup& servos, const Counts& goals, std::int64_t watchdog) {
  try {
    // One that has tripped keeps the goals read-only until it is switched off.
    write_surely(servos, &ServoModel::bus_watchdog, kOff, "bus watchdog");
    write_surely(servos, &ServoModel::goal_position, goals, "goal position");
    write_surely(servos, &ServoModel::bus_watchdog, watchdog, "bus watchdog");
    write_surely(servos, &ServoModel::torque_enable, kOn, "torque");
  } catch (const DeviceError&) {
    try {
      switch_off(servos);
    } catch (const DeviceError&) {
      // What has gone wrong first says more.
    }
    throw;
  }
}

void switch_off(ServoGroup& servos) {
  write_surely(servos, &ServoModel::torque_enable, kOff, "torque");
  write_surely(servos, &ServoModel::bus_watchdog, kOff, "bus watchdog");
}

Bytes switch_off_frame(const ServoGroup& servos) {
  return encode(servos.write_instruction(&ServoModel::torque_enable, Counts(servos.size(), kOff)));
}

}  // namespace scarab::bridge::dynamixel
