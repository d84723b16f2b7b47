#include "services/robot_bridge/drivers/dynamixel/setup.hpp"

#include <algorithm>
#include <optional>

#include "services/robot_bridge/drivers/dynamixel/torque.hpp"

namespace scarab::bridge::dynamixel {
namespace {

constexpr int kPings = 2;  // of each device
constexpr std::size_t kPingBytes = 3;
constexpr std::size_t kReasonsInAMessage = 3;  // names are told all

/// Of the built-in model (e-Manual, Protocol 2.0, "Fast Bulk Read", supported devices: X430
/// series).
constexpr int kFastSyncReadFirmware = 45;

/// Bits of the drive mode with which a servo does something else than it is told: turns the other
/// way (calibration's part), or switches its torque on by itself when it gets a goal (e-Manual,
/// XM430-W350, "Drive Mode").
constexpr std::int64_t kUnwantedDriveModes = kReverseDriveMode | 0x08;

std::optional<PingAnswer> find(Bus& bus, std::uint8_t id) {
  for (int i = 0; i < kPings; ++i) {
    if (const auto status = bus.ask_once(ping(id), kPingBytes)) return as_ping_answer(status->data);
  }
  return std::nullopt;
}

/// Who is on the bus.
struct Census {
  std::size_t found = 0;
  std::vector<std::string> silent;  ///< names
  std::vector<std::string> others;  ///< who is not what it should be, and why
};

/// "a, b", no more than the first `most`, "and 3 more".
std::string listed(const std::vector<std::string>& texts, std::size_t most) {
  std::string list;
  for (std::size_t i = 0; i < std::min(texts.size(), most); ++i) {
    list += (i == 0 ? "" : ", ") + texts[i];
  }
  if (texts.size() > most) list += " and " + std::to_string(texts.size() - most) + " more";
  return list;
}

void check_servo(ServoGroup& servos, std::size_t index, const PingAnswer& answer, Census& census) {
  const int wanted = servos.servos()[index].model.model_number;
  const bool is_built_in = answer.model_number == ServoModel{}.model_number;
  if (answer.model_number != wanted) {
    census.others.push_back(servos.name_of(index) + " is a model " +
                            std::to_string(static_cast<int>(answer.model_number)) +
                            " in place of " + std::to_string(wanted));
  } else if (is_built_in && servos.kind() == SyncReadKind::kFast &&
             answer.firmware < kFastSyncReadFirmware) {
    census.others.push_back(servos.name_of(index) + " has firmware " +
                            std::to_string(static_cast<int>(answer.firmware)) +
                            ", fast sync reads need " + std::to_string(kFastSyncReadFirmware) +
                            " (or `sync_read: plain`)");
  }
}

/// Writes it to the servos that have another value, one by one: each confirms it.
void settle(ServoGroup& servos, std::size_t index, ItemOf item, std::int64_t wanted) {
  if (servos.read_one(index, item) != wanted) servos.write_one(index, item, wanted);
}

void check_drive_mode(ServoGroup& servos) {
  const Counts modes = servos.read(&ServoModel::drive_mode);
  for (std::size_t i = 0; i < servos.size(); ++i) {
    if ((modes[i] & kUnwantedDriveModes) == 0) continue;
    throw DeviceError(servos.bus().path() + ": " + servos.name_of(i) + " is in drive mode " +
                      std::to_string(modes[i]) +
                      "; needs one without reversal (a calibration's direction is for that) and "
                      "without torque by goal update");
  }
}

}  // namespace

void find_devices(ServoGroup& servos, const std::vector<std::uint8_t>& boards) {
  Bus& bus = servos.bus();
  Census census;
  for (std::size_t i = 0; i < servos.size(); ++i) {
    const auto answer = find(bus, servos.servos()[i].id);
    if (answer) {
      ++census.found;
      check_servo(servos, i, *answer, census);
    } else {
      census.silent.push_back(servos.name_of(i));
    }
  }
  for (const std::uint8_t id : boards) {
    if (find(bus, id)) {
      ++census.found;
    } else {
      census.silent.push_back(bus.name_of(id));
    }
  }
  if (census.found == 0) {
    throw DeviceError(bus.path() +
                      ": no device answers; is the power on, and is it their baud rate?");
  }
  if (!census.silent.empty())
    throw DeviceError(bus.path() + ": missing: " + listed(census.silent, census.silent.size()));
  if (!census.others.empty())
    throw DeviceError(bus.path() + ": " + listed(census.others, kReasonsInAMessage));
}

void prepare(ServoGroup& servos) {
  // In RAM, so before anything that waits for what it lets through; nobody confirms it at level 0.
  servos.write(&ServoModel::status_return_level, kReturnAllStatuses);
  switch_off(servos);
  for (std::size_t i = 0; i < servos.size(); ++i) {
    settle(servos, i, &ServoModel::return_delay, 0);
    settle(servos, i, &ServoModel::operating_mode, kPositionControlMode);
  }
  check_drive_mode(servos);
}

std::vector<ServoLimits> read_limits(ServoGroup& servos) {
  const Counts min = servos.read(&ServoModel::min_position_limit);
  const Counts max = servos.read(&ServoModel::max_position_limit);
  const Counts temperature = servos.read(&ServoModel::temperature_limit);
  std::vector<ServoLimits> limits;
  for (std::size_t i = 0; i < servos.size(); ++i) {
    const Servo& servo = servos.servos()[i];
    const JointRange reached = reach(servo.calibration);
    const std::int64_t one_end = goal_ticks(servo, reached.min_rad);
    const std::int64_t other_end = goal_ticks(servo, reached.max_rad);
    const std::int64_t low = std::min(one_end, other_end);
    const std::int64_t high = std::max(one_end, other_end);
    if (min[i] > max[i] || high < min[i] || low > max[i]) {
      throw DeviceError(servos.bus().path() + ": " + servos.name_of(i) + " takes goals from " +
                        std::to_string(min[i]) + " to " + std::to_string(max[i]) +
                        ", its calibration means " + std::to_string(low) + " to " +
                        std::to_string(high));
    }
    limits.push_back({std::max(low, min[i]), std::min(high, max[i]),
                      static_cast<double>(temperature[i]) * servo.model.temperature_limit.unit});
  }
  return limits;
}

}  // namespace scarab::bridge::dynamixel
