#pragma once

#include <memory>
#include <optional>
#include <string>

#include "common/config/range.hpp"
#include "common/robot/robot_model.hpp"
#include "services/robot_bridge/core/calibration.hpp"
#include "services/robot_bridge/core/driver.hpp"

/// AMOS II, the paper's robot, by its second board (V2): see protocol/frames.hpp for the wire,
/// protocol/values.hpp for how angles become bytes.
namespace scarab::bridge::amosii {

/// One axis of the inclinometer: angle = (byte - zero_byte) * rad_per_byte; negative where it falls
/// as the angle grows. Nobody has published these figures: a reconstruction, to be measured.
struct InclinationAxis {
  double zero_byte = 128;
  double rad_per_byte = 0.01;
};

struct Inclinometer {
  InclinationAxis roll;   ///< the board's x, about the walking direction
  InclinationAxis pitch;  ///< the board's y, about the sideways direction
};

/// Current of all motors = (byte - zero_byte) * a_per_byte. The laboratory's software gives
/// (byte * 5 / 256 - 2.5) / 0.037 for its ZAP 25 sensor: zero at 128, 0.528 A a byte.
struct MotorCurrent {
  double zero_byte = 128;
  double a_per_byte = 0.528;
};

struct Config {
  std::string port;
  /// Longest wait for a reply, from the get on; it takes 6 ms on the wire, 12 behind a set.
  double reply_timeout_s = 0.025;
  unsigned attempts = 3;  ///< gets before the board is given up
  /// Silence on the line before and after each set. The laboratory's software keeps 10 ms; whether
  /// the board needs them is not published.
  double pause_s = 0.01;
  double foot_full_scale_n = 0;  ///< force on a foot whose scaled input reads 1; more is cut off
  std::optional<Inclinometer> inclinometer;
  MotorCurrent motor_current;
};

template <class Fields>
void visit_fields(Fields& f, InclinationAxis& c) {
  f("zero_byte", c.zero_byte, config::Range{1, 255});
  f("rad_per_byte", c.rad_per_byte, config::Range{-0.1, 0.1});
}

template <class Fields>
void visit_fields(Fields& f, Inclinometer& c) {
  f("roll", c.roll);
  f("pitch", c.pitch);
}

template <class Fields>
void visit_fields(Fields& f, MotorCurrent& c) {
  f("zero_byte", c.zero_byte, config::Range{1, 255});
  f("a_per_byte", c.a_per_byte, config::Range{-10, 10});
}

template <class Fields>
void visit_fields(Fields& f, Config& c) {
  f("port", c.port);
  f("reply_timeout_s", c.reply_timeout_s, config::Range{0.006, 1});
  f("attempts", c.attempts, config::Range{1, 10});
  f("pause_s", c.pause_s, config::Range{0, 0.1});
  f("foot_full_scale_n", c.foot_full_scale_n, config::kPositive);
  f("inclinometer", c.inclinometer);
  f("motor_current", c.motor_current);
}

/// A board that is not opened yet. `device_override`, unless empty, takes the place of the port.
/// Throws std::invalid_argument naming the joint if one of the robot's has no calibration.
[[nodiscard]] std::unique_ptr<Driver> make(const Config& config, const robot::RobotModel& robot,
                                           const Calibration& calibration,
                                           const std::string& device_override);

}  // namespace scarab::bridge::amosii
