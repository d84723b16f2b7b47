#include "services/robot_bridge/calibrate/by_hand.hpp"

#include <fmt/format.h>

#include "services/robot_bridge/calibrate/words.hpp"

namespace scarab::bridge::calibrate {
namespace {

constexpr std::chrono::milliseconds kReadingPeriod{50};

}  // namespace

double servo_angle(Driver& driver, std::size_t joint) {
  const JointReadings position = driver.read().position_rad;
  if (position.source[joint] == Source::kMeasured) return position.value[joint];
  throw DeviceError(std::string(robot::kJointNames[joint]) + ": its servo does not tell its angle");
}

ByHand::Look ByHand::watch(std::size_t joint) {
  double servo_rad = servo_angle(driver_, joint);
  Travel travel(servo_rad);
  for (;;) {
    console_.live(fmt::format("  {}: servo {}, seen {:+.3f} to {:+.3f}", robot::kJointNames[joint],
                              angle_words(servo_rad), travel.min_rad(), travel.max_rad()));
    const Key key = console_.key(kReadingPeriod);
    servo_rad = servo_angle(driver_, joint);
    travel.see(servo_rad);
    if (key == Key::kEnter || key == Key::kSkip || key == Key::kQuit) {
      return {key, servo_rad, travel};
    }
  }
}

Finding ByHand::find(std::size_t joint) {
  const std::string name(robot::kJointNames[joint]);
  console_.line(name + ": put it so: " + pose_words(joint, reference_rad_[joint]) +
                ". Enter: it stands so.");
  const Look stands = watch(joint);
  if (stands.key != Key::kEnter) return ended_by(stands.key);

  std::optional<int> direction;
  while (!direction) {
    console_.line(name + ": move it " + positive_words(joint) +
                  ", 10 degrees or more, and hold it there. Enter.");
    const Look moved = watch(joint);
    if (moved.key != Key::kEnter) return ended_by(moved.key);
    direction = direction_of(stands.servo_rad, moved.servo_rad);
    if (!direction) console_.line(name + ": that was less than 6 degrees; once more.");
  }

  for (;;) {
    console_.line(name + ": move it to both ends of what it can do. Enter when it has been there.");
    const Look walked = watch(joint);
    if (walked.key != Key::kEnter) return ended_by(walked.key);
    if (walked.travel.is_walked_through()) {
      return {Finding::Outcome::kFound,
              measured(stands.servo_rad, reference_rad_[joint], *direction, walked.travel)};
    }
    console_.line(name + ": that was less than 17 degrees of travel; once more.");
  }
}

}  // namespace scarab::bridge::calibrate
