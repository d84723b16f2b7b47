#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "common/config/check.hpp"
#include "common/config/range.hpp"
#include "common/robot/robot_model.hpp"
#include "services/robot_bridge/core/calibration.hpp"
#include "services/robot_bridge/core/driver.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/control_table.hpp"

/// Servos that speak DYNAMIXEL Protocol 2.0 on one bus, with boards for what they cannot measure.
namespace scarab::bridge::dynamixel {

/// How the servos are read all at once: each answers for itself, or all in one packet (servos of
/// the X series from firmware 45 on).
enum class SyncReadKind { kPlain, kFast };

/// The servo of one joint.
struct ServoConfig {
  std::uint8_t id = 0;
  std::string model{kBuiltInModel};  ///< built in, or one of Config::models
};

/// A board on the bus that measures the trunk's inclination and motion. Units to SI: roll and pitch
/// in rad, the rest about and along the trunk's x forward, y left, z up.
struct ImuConfig {
  std::uint8_t id = 0;
  Item roll;
  Item pitch;
  std::array<Item, 3> angular_velocity;
  std::array<Item, 3> acceleration;  ///< with gravity, as an accelerometer feels it
};

/// A board on the bus that measures the feet's forces: N per count, in the order of the leg slots.
struct FootForceConfig {
  std::uint8_t id = 0;
  std::array<Item, robot::kLegCount> force;
};

struct Config {
  std::string port;
  unsigned baud = 1000000;
  SyncReadKind sync_read = SyncReadKind::kFast;
  /// Longest wait for an answer, beyond the time that its bytes take on the bus.
  double reply_timeout_s = 0.005;
  unsigned retries = 2;         ///< of an exchange, before the device is given up
  double bus_watchdog_s = 0.2;  ///< the servos stop after so long without an instruction
  std::map<std::string, ServoConfig> servos;  ///< by joint name
  std::map<std::string, ServoModel> models;   ///< besides the one that is built in
  std::optional<ImuConfig> imu;
  std::optional<FootForceConfig> foot_force;
};

constexpr std::array<std::pair<std::string_view, SyncReadKind>, 2> enum_names(SyncReadKind) {
  return {{{"plain", SyncReadKind::kPlain}, {"fast", SyncReadKind::kFast}}};
}

constexpr std::array<std::pair<std::string_view, Type>, 7> enum_names(Type) {
  return {{{"u8", Type::kU8},
           {"i8", Type::kI8},
           {"u16", Type::kU16},
           {"i16", Type::kI16},
           {"u32", Type::kU32},
           {"i32", Type::kI32},
           {"f32", Type::kF32}}};
}

inline constexpr config::Range kIds{0, kMaxId};

template <class Fields>
void visit_fields(Fields& f, Item& c) {
  f("address", c.address);
  f("type", c.type);
  f("unit", c.unit);
}

template <class Fields>
void visit_fields(Fields& f, ServoModel& c) {
  f("model_number", c.model_number);
  f("torque_constant_nm_a", c.torque_constant_nm_a, config::kPositive);
  f.optional("centre_ticks", c.centre_ticks);
  for_each_item(c, [&f](std::string_view name, Item& item) { f.optional(name, item); });
}

template <class Fields>
void visit_fields(Fields& f, ServoConfig& c) {
  f("id", c.id, kIds);
  f.optional("model", c.model);
}

template <class Fields>
void visit_fields(Fields& f, ImuConfig& c) {
  f("id", c.id, kIds);
  f("roll", c.roll);
  f("pitch", c.pitch);
  f("angular_velocity", c.angular_velocity);
  f("acceleration", c.acceleration);
}

template <class Fields>
void visit_fields(Fields& f, FootForceConfig& c) {
  f("id", c.id, kIds);
  f("force", c.force);
}

template <class Fields>
void visit_fields(Fields& f, Config& c) {
  f("port", c.port);
  f("baud", c.baud, config::Range{9600, 4500000});
  f("sync_read", c.sync_read);
  f("reply_timeout_s", c.reply_timeout_s, config::Range{0.001, 0.1});
  f("retries", c.retries, config::Range{0, 10});
  f("bus_watchdog_s", c.bus_watchdog_s, config::Range{0.02, 2.54});
  f("servos", c.servos);
  f.optional("models", c.models);
  f.optional("imu", c.imu);
  f.optional("foot_force", c.foot_force);
}

/// A unit of 0 would measure nothing.
void validate(const Item& c, const config::Check& check);
/// Known joints and models, no ID twice, and models that can be read with one instruction.
void validate(const Config& c, const config::Check& check);

/// The model of that name; none if there is no such.
[[nodiscard]] std::optional<ServoModel> find_model(const Config& config, const std::string& name);

/// A bus that is not opened yet. `device_override`, unless empty, takes the place of the port.
/// Throws std::invalid_argument naming the joint if one of the robot's has no servo or no
/// calibration.
[[nodiscard]] std::unique_ptr<Driver> make(const Config& config, const robot::RobotModel& robot,
                                           const Calibration& calibration,
                                           const std::string& device_override);

}  // namespace scarab::bridge::dynamixel
