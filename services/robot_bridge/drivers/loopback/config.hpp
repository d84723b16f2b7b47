#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/config/check.hpp"
#include "common/config/range.hpp"
#include "common/robot/robot_model.hpp"
#include "services/robot_bridge/core/calibration.hpp"
#include "services/robot_bridge/core/driver.hpp"

/// No device: servos that follow their goals at their speed limit below a trunk that stays level,
/// for tests and dry runs, with faults at will.
namespace scarab::bridge::loopback {

enum class FaultKind {
  kLost,     ///< the device is not there: every call fails
  kHot,      ///< the joint's servo has `value` degrees Celsius
  kCurrent,  ///< the joint's servo draws `value` A
  kSupply,   ///< the robot draws `value` A
  kTilt,     ///< the trunk's pitch is `value` rad
  kStuck,    ///< the joint does not move
  kError,    ///< the joint's servo reports an error of its own
  kDeaf,     ///< hold() and release() are not confirmed
};

struct Fault {
  FaultKind kind{};
  std::optional<std::string> joint;  ///< a joint's name; none where the kind needs none
  double value = 0;
  double after_s = 0;  ///< since the motors were first switched on
  double for_s = 1e9;
};

/// How a servo really sits in its joint, where that differs from what the calibration says.
struct Mounting {
  double offset_rad = 0;
  int direction = 1;
};

struct Config {
  double appears_after_s = 0;              ///< until then nothing is there
  std::map<std::string, double> pose_rad;  ///< joints that do not stand at 0 at first
  std::map<std::string, Mounting> mounting;
  std::vector<Fault> faults;
};

constexpr std::array<std::pair<std::string_view, FaultKind>, 8> enum_names(FaultKind) {
  return {{{"lost", FaultKind::kLost},
           {"hot", FaultKind::kHot},
           {"current", FaultKind::kCurrent},
           {"supply", FaultKind::kSupply},
           {"tilt", FaultKind::kTilt},
           {"stuck", FaultKind::kStuck},
           {"error", FaultKind::kError},
           {"deaf", FaultKind::kDeaf}}};
}

/// Slot of a joint by its name; none if there is no such joint.
[[nodiscard]] std::optional<std::size_t> joint_of(std::string_view name);

[[nodiscard]] bool needs_joint(FaultKind kind);

template <class Fields>
void visit_fields(Fields& f, Fault& c) {
  f("kind", c.kind);
  f.optional("joint", c.joint);
  f.optional("value", c.value);
  f.optional("after_s", c.after_s, config::kNonNegative);
  f.optional("for_s", c.for_s, config::kPositive);
}

inline void validate(const Fault& c, const config::Check& check) {
  check.require(!c.joint || joint_of(*c.joint), "joint", "there is no such joint");
  check.require(c.joint.has_value() == needs_joint(c.kind), "joint",
                "hot, current, stuck and error are of a joint, the others are not");
}

template <class Fields>
void visit_fields(Fields& f, Mounting& c) {
  f("offset_rad", c.offset_rad);
  f("direction", c.direction);
}

inline void validate(const Mounting& c, const config::Check& check) {
  check.require(c.direction == 1 || c.direction == -1, "direction", "must be 1 or -1");
}

template <class Fields>
void visit_fields(Fields& f, Config& c) {
  f.optional("appears_after_s", c.appears_after_s, config::kNonNegative);
  f.optional("pose_rad", c.pose_rad);
  f.optional("mounting", c.mounting);
  f.optional("faults", c.faults);
}

inline void validate(const Config& c, const config::Check& check) {
  for (const auto& entry : c.pose_rad) {
    check.require(joint_of(entry.first).has_value(), "pose_rad", "no joint " + entry.first);
  }
  for (const auto& entry : c.mounting) {
    check.require(joint_of(entry.first).has_value(), "mounting", "no joint " + entry.first);
  }
}

/// `device_override` is taken and means nothing: there is no port. Throws std::invalid_argument
/// naming the joint if one of the robot's has no calibration.
[[nodiscard]] std::unique_ptr<Driver> make(const Config& config, const robot::RobotModel& robot,
                                           const Calibration& calibration,
                                           const std::string& device_override);

}  // namespace scarab::bridge::loopback
