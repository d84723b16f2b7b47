#include "services/robot_bridge/calibrate/by_keys.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "services/robot_bridge/calibrate/words.hpp"

namespace scarab::bridge::calibrate {
namespace {

using Clock = std::chrono::steady_clock;

/// Goals take a step so often; a step is what the speed allows in this time.
constexpr std::chrono::milliseconds kPeriod{50};

bool ends(Key key) {
  return key == Key::kEnter || key == Key::kSkip || key == Key::kKeep || key == Key::kQuit;
}

}  // namespace

ByKeys::ByKeys(Driver& driver, Console& console, const robot::RobotModel& robot,
               const Calibration& nominal, const Calibration& known,
               const robot::JointVector& reference_rad, std::chrono::milliseconds pace)
    : driver_(driver),
      console_(console),
      robot_(robot),
      nominal_(nominal),
      known_(known),
      reference_rad_(reference_rad),
      pace_(pace) {
  for (std::size_t joint = 0; joint < robot::kJointCount; ++joint) {
    if (!known.joints[joint]) continue;  // stays in the middle of its travel
    wanted_rad_[joint] = to_servo_rad(*known.joints[joint], reference_rad[joint]);
  }
  goal_rad_ = wanted_rad_;
}

bool ByKeys::power() {
  console_.line(
      "This robot does not tell where its joints are, and its motors cannot be switched on "
      "gently:\nevery joint jumps to its place now, and holds until the robot is switched off. "
      "Hold it up, legs free.\nEnter: go on; q: leave it.");
  Key key = Key::kNone;
  while (key != Key::kEnter && key != Key::kQuit) key = console_.key(kPeriod);
  if (key == Key::kQuit) return false;
  driver_.activate(goal_rad_);
  return true;
}

void ByKeys::approach() {
  const double reach_rad = kSpeed_rad_s * std::chrono::duration<double>(kPeriod).count();
  for (std::size_t joint = 0; joint < robot::kJointCount; ++joint) {
    goal_rad_[joint] += std::clamp(wanted_rad_[joint] - goal_rad_[joint], -reach_rad, reach_rad);
  }
  driver_.write(goal_rad_);
}

ByKeys::Look ByKeys::drive(std::size_t joint, double joint_rad) {
  const JointCalibration& travel = nominal_.joints[joint].value();
  for (;;) {
    console_.live(fmt::format("  {}: servo {} of {:+.2f} to {:+.2f}", robot::kJointNames[joint],
                              angle_words(wanted_rad_[joint]), travel.min_rad, travel.max_rad));
    const Key key = keys_until_step(wanted_rad_[joint], travel);
    if (ends(key)) {
      wanted_rad_[joint] = goal_rad_[joint];  // what the person saw, not where it was going
      return {key, {goal_rad_[joint], joint_rad}};
    }
    approach();
  }
}

Key ByKeys::keys_until_step(double& wanted_rad, const JointCalibration& travel) {
  const auto step_time = Clock::now() + pace_;
  Key key = Key::kNone;
  do {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(step_time - Clock::now());
    key = console_.key(std::max(left, std::chrono::milliseconds(0)));
    if (key == Key::kPlus) wanted_rad += kStep_rad;
    if (key == Key::kMinus) wanted_rad -= kStep_rad;
    wanted_rad = std::clamp(wanted_rad, travel.min_rad, travel.max_rad);
  } while (!ends(key) && Clock::now() < step_time);
  return key;
}

Finding ByKeys::find(std::size_t joint) {
  const std::string name(robot::kJointNames[joint]);
  const double first_rad = reference_rad_[joint];
  console_.line(name + ": drive it with + and - until it stands so: " +
                pose_words(joint, first_rad) + ". Enter: it does.");
  const Look first = drive(joint, first_rad);
  if (first.key != Key::kEnter) return ended_by(first.key);

  const double second_rad = second_look_rad(robot_.joints[joint], first_rad);
  const auto& known = known_.joints[joint];
  for (;;) {
    console_.line(name + ": now until it stands so: " + pose_words(joint, second_rad) +
                  ". Enter: it does." +
                  (known ? " k: keep direction and travel of the file." : ""));
    const Look second = drive(joint, second_rad);
    wanted_rad_[joint] = first.standing.servo_rad;  // back on the way to the next joint
    if (second.key == Key::kKeep && known) {
      JointCalibration kept = *known;
      kept.offset_rad = offset_of(first.standing.servo_rad, kept.direction, first_rad);
      return {Finding::Outcome::kFound, kept};
    }
    if (second.key == Key::kSkip || second.key == Key::kQuit) return ended_by(second.key);
    const auto found = driven(nominal_.joints[joint].value(), first.standing, second.standing);
    if (found && second.key == Key::kEnter) return {Finding::Outcome::kFound, *found};
    console_.line(name + ": that is not far enough from the first place; once more.");
  }
}

}  // namespace scarab::bridge::calibrate
