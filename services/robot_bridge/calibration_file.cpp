#include "services/robot_bridge/calibration_file.hpp"

#include <cstddef>

#include "common/config/config.hpp"

namespace scarab::bridge {
namespace {

constexpr config::Range kTurns{-6.3, 6.3};  // rad; catches degrees

}  // namespace

template <class Fields>
void visit_fields(Fields& f, JointCalibration& c) {
  f("offset_rad", c.offset_rad, kTurns);
  f("direction", c.direction, config::Range{-1, 1});
  f("min_rad", c.min_rad, kTurns);
  f("max_rad", c.max_rad, kTurns);
}

void validate(const JointCalibration& c, const config::Check& check) {
  check.require(c.direction != 0, "direction", "must be 1 or -1");
  check.require(c.min_rad < c.max_rad, "max_rad", "must be above min_rad");
  check.require(c.offset_rad >= c.min_rad && c.offset_rad <= c.max_rad, "offset_rad",
                "must be within the servo's range [min_rad, max_rad]");
}

template <class Fields>
void visit_fields(Fields& f, Calibration& c) {
  for (std::size_t slot = 0; slot < c.joints.size(); ++slot) {
    f(robot::kJointNames[slot], c.joints[slot]);
  }
}

Calibration load_calibration(const std::filesystem::path& path) {
  return config::load<Calibration>(path);
}

Calibration load_calibration(const std::filesystem::path& path, const robot::RobotModel& robot) {
  const Calibration calibration = load_calibration(path);
  const config::Document document = config::read_extended(path);
  const config::Check check{config::Cursor(document)};
  const robot::RobotModel reachable = within_reach(robot, calibration);
  for (std::size_t slot = 0; slot < calibration.joints.size(); ++slot) {
    const robot::Joint& joint = robot.joints[slot];
    if (!joint.present) continue;
    check.require(calibration.joints[slot].has_value(), robot::kJointNames[slot],
                  "is absent, but the robot " + robot.name + " has this joint");
    const robot::Joint& kept = reachable.joints[slot];
    check.require(kept.min_rad < kept.max_rad, robot::kJointNames[slot],
                  "is mounted so that the servo reaches nothing of the joint's range [" +
                      config::format_number(joint.min_rad) + ", " +
                      config::format_number(joint.max_rad) + "] of the robot " + robot.name);
  }
  return calibration;
}

Calibration load_calibration_text(const std::string& file, const std::string& text) {
  return config::load_text<Calibration>(file, text);
}

std::string dump_calibration(const Calibration& calibration) { return config::dump(calibration); }

std::string calibration_schema() {
  return config::schema<Calibration>("Scarab: config/calibration");
}

}  // namespace scarab::bridge
