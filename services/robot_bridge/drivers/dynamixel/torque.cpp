#include "services/robot_bridge/drivers/dynamixel/torque.hpp"

#include <cstddef>
#include <cstdlib>
#include <optional>
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

/// What is written to all servos, and what may come back.
struct Setting {
  ItemOf item;
  const char* name;
  std::int64_t tolerance = 0;
};

constexpr Setting kTorque{&ServoModel::torque_enable, "torque"};
constexpr Setting kWatchdog{&ServoModel::bus_watchdog, "bus watchdog"};
/// 0.05 rad: whether a servo without torque keeps the goal that it was told or the one where it
/// stands is not published; either is where the joint is to be held.
constexpr Setting kGoal{&ServoModel::goal_position, "goal position", 32};

/// The first servo whose value is not the one written.
std::optional<std::size_t> first_wrong(const Counts& counts, const Counts& taken,
                                       std::int64_t tolerance) {
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (std::abs(taken[i] - counts[i]) > tolerance) return i;
  }
  return std::nullopt;
}

/// Until it reads back as written.
void write_surely(ServoGroup& servos, const Setting& setting, const Counts& counts) {
  for (int left = kTries; left > 0; --left) {
    servos.write(setting.item, counts);
    const Counts taken = servos.read(setting.item);
    const auto wrong = first_wrong(counts, taken, setting.tolerance);
    if (!wrong) return;
    if (left > 1) continue;
    throw DeviceError(servos.bus().path() + ": " + servos.name_of(*wrong) + " does not take " +
                      setting.name + " " + std::to_string(counts[*wrong]) + ", it has " +
                      std::to_string(taken[*wrong]) + hardware_error(servos, *wrong));
  }
}

void write_surely(ServoGroup& servos, const Setting& setting, std::int64_t count) {
  write_surely(servos, setting, Counts(servos.size(), count));
}

}  // namespace

void switch_on(ServoGroup& servos, const Counts& goals, std::int64_t watchdog) {
  try {
    // One that has tripped keeps the goals read-only until it is switched off.
    write_surely(servos, kWatchdog, kOff);
    write_surely(servos, kGoal, goals);
    write_surely(servos, kWatchdog, watchdog);
    write_surely(servos, kTorque, kOn);
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
  write_surely(servos, kTorque, kOff);
  write_surely(servos, kWatchdog, kOff);
}

Bytes switch_off_frame(const ServoGroup& servos) {
  return encode(servos.write_instruction(&ServoModel::torque_enable, Counts(servos.size(), kOff)));
}

}  // namespace scarab::bridge::dynamixel
